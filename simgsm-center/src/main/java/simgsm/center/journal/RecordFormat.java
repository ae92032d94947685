package simgsm.center.journal;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.zip.CRC32C;

/**
 * A record in a file: mark (4 octets), length of the contents (4), CRC-32C of length, sequence and contents (4), sequence
 * (8), contents. Integers are big-endian. Sequence numbers rise by one within a file.
 */
final class RecordFormat {
    static final int HEADER_LENGTH = 20;
    static final int MAX_CONTENTS = 64 * 1024;

    /** Start of every record, used to find the next one after damage. */
    static final int MARK = 0xf5a70e5d;

    private RecordFormat() {}

    static void write(ByteArrayOutputStream to, long sequence, byte[] contents) {
        if (contents.length == 0 || contents.length > MAX_CONTENTS) {
            throw new IllegalArgumentException(
                    "expected 1 to " + MAX_CONTENTS + " octets of contents, found " + contents.length);
        }
        ByteBuffer header = ByteBuffer.allocate(HEADER_LENGTH)
                .putInt(MARK)
                .putInt(contents.length)
                .putInt(checksum(contents.length, sequence, ByteBuffer.wrap(contents)))
                .putLong(sequence);
        to.writeBytes(header.array());
        to.writeBytes(contents);
    }

    static int checksum(int length, long sequence, ByteBuffer contents) {
        CRC32C crc = new CRC32C();
        crc.update(ByteBuffer.allocate(Integer.BYTES + Long.BYTES)
                .putInt(length)
                .putLong(sequence)
                .flip());
        crc.update(contents);
        return (int) crc.getValue();
    }
}
