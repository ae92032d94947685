package simrobot.replay;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.zip.CRC32C;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.Inflater;
import simgsm.octets.OctetWriter;

/** Records between octets of a file and their contents: length, kind, checksum, deflating. */
final class RecordCodec {
    /** Begin and end of KEY and CHANGES stay readable without inflating. */
    static final int TIMES_OCTETS = 16;

    private static final int WORTH_DEFLATING_OCTETS = 64;

    /** A record as it stands in the file. @param kind as written, with {@link RecordingFormat#DEFLATED} */
    record Stored(int kind, byte[] content) {
        RecordingFormat.Kind meaning() {
            int ordinal = kind & ~RecordingFormat.DEFLATED;
            if (ordinal >= RecordingFormat.Kind.values().length) {
                throw new DamagedException("a record of kind " + ordinal + ", which this version does not know");
            }
            return RecordingFormat.Kind.values()[ordinal];
        }

        int clearOctets() {
            RecordingFormat.Kind meaning = meaning();
            return meaning == RecordingFormat.Kind.KEY || meaning == RecordingFormat.Kind.CHANGES ? TIMES_OCTETS : 0;
        }

        byte[] inflated() {
            return (kind & RecordingFormat.DEFLATED) == 0 ? content : inflate(content, clearOctets());
        }
    }

    private RecordCodec() {}

    static byte[] header() {
        OctetWriter out = new OctetWriter();
        RecordingFormat.MAGIC.chars().forEach(out::octet);
        return out.twoOctets(RecordingFormat.VERSION)
                .eightOctets(simrobot.simulation.Simulation.STEP_NANOS)
                .toArray();
    }

    static byte[] encode(RecordingFormat.Kind kind, byte[] content) {
        Stored stored = deflated(new Stored(kind.ordinal(), content));
        return new OctetWriter()
                .fourOctets(stored.content.length)
                .octet(stored.kind)
                .bytes(stored.content)
                .fourOctets(checksum(stored.kind, stored.content))
                .toArray();
    }

    /**
     * The next record; null where the file ends, whole or within a record.
     *
     * @throws DamagedException when it is not what was written
     */
    static Stored read(DataInputStream in) throws IOException {
        try {
            int length = in.readInt();
            if (length < 0 || length > RecordingFormat.MAX_CONTENT_OCTETS) {
                throw new DamagedException("a record of " + length + " octets");
            }
            int kind = in.readUnsignedByte();
            byte[] content = readOctets(in, length);
            int checksum = in.readInt();
            if (checksum != checksum(kind, content)) {
                throw new DamagedException("a record whose checksum is wrong");
            }
            return new Stored(kind, content);
        } catch (EOFException torn) {
            return null;
        }
    }

    /** A length that lies costs no more memory than the file has octets. */
    private static byte[] readOctets(InputStream in, int length) throws IOException {
        byte[] octets = in.readNBytes(length);
        if (octets.length < length) {
            throw new EOFException();
        }
        return octets;
    }

    private static int checksum(int kind, byte[] content) {
        CRC32C crc = new CRC32C();
        crc.update(kind);
        crc.update(content, 0, content.length);
        return (int) crc.getValue();
    }

    private static Stored deflated(Stored plain) {
        int clear = plain.clearOctets();
        if (plain.content.length < clear + WORTH_DEFLATING_OCTETS) {
            return plain;
        }
        Deflater deflater = new Deflater(Deflater.BEST_SPEED, true);
        try {
            deflater.setInput(plain.content, clear, plain.content.length - clear);
            deflater.finish();
            byte[] out = new byte[plain.content.length];
            System.arraycopy(plain.content, 0, out, 0, clear);
            int size = deflater.deflate(out, clear, out.length - clear);
            return deflater.finished()
                    ? new Stored(plain.kind | RecordingFormat.DEFLATED, java.util.Arrays.copyOf(out, clear + size))
                    : plain;
        } finally {
            deflater.end();
        }
    }

    private static byte[] inflate(byte[] content, int clear) {
        Inflater inflater = new Inflater(true);
        try {
            inflater.setInput(content, clear, content.length - clear);
            ByteArrayOutputStream out = new ByteArrayOutputStream(4 * content.length);
            out.write(content, 0, clear);
            byte[] part = new byte[64 << 10];
            while (!inflater.finished()) {
                int size = inflater.inflate(part);
                if (size == 0 || out.size() > RecordingFormat.MAX_CONTENT_OCTETS) {
                    throw new DamagedException("a record that cannot be inflated");
                }
                out.write(part, 0, size);
            }
            return out.toByteArray();
        } catch (DataFormatException e) {
            throw new DamagedException("a record that cannot be inflated");
        } finally {
            inflater.end();
        }
    }
}
