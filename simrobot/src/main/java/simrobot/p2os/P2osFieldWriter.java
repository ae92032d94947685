package simrobot.p2os;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Writes the protocol's fields: whole numbers little endian, texts ended by a NUL. */
final class P2osFieldWriter {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream(200);

    P2osFieldWriter int1(int value) {
        bytes.write(value);
        return this;
    }

    P2osFieldWriter int2(int value) {
        return int1(value).int1(value >> 8);
    }

    P2osFieldWriter int4(int value) {
        return int2(value).int2(value >> 16);
    }

    /** The same number of two bytes several times. */
    P2osFieldWriter int2s(int... values) {
        for (int value : values) {
            int2(value);
        }
        return this;
    }

    P2osFieldWriter text(String text) {
        return raw(text.getBytes(StandardCharsets.US_ASCII)).int1(0);
    }

    P2osFieldWriter raw(byte[] more) {
        bytes.writeBytes(more);
        return this;
    }

    /** The one big-endian field. */
    P2osFieldWriter checksum(int value) {
        return int1(value >> 8).int1(value);
    }

    byte[] toBytes() {
        return bytes.toByteArray();
    }
}
