package simgsm.tools.audio;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioFormat.Encoding;
import simgsm.speech.SpeechCodec;

/**
 * The header of a RIFF or RF64 file: format, position and length of its samples. Unknown chunks are skipped, and a
 * missing length means "to the end of the file".
 *
 * @param dataAt index of the first sample's first octet
 * @param dataOctets {@link Long#MAX_VALUE} for "to the end"
 */
record WavHeader(AudioFormat format, int dataAt, long dataOctets) {
    private static final int CHUNK_HEAD_OCTETS = 8;
    /** Unknown length, written by programs that write to a pipe. */
    private static final long UNKNOWN = 0xFFFF_FFFFL;
    /** The octets that make a format tag a GUID (RFC 2361, 4). */
    private static final byte[] GUID_END = {
        0, 0, 0, 0, 0x10, 0, (byte) 0x80, 0, 0, (byte) 0xAA, 0, 0x38, (byte) 0x9B, 0x71
    };

    private static final int PCM = 1;
    private static final int IEEE_FLOAT = 3;
    private static final int A_LAW = 6;
    private static final int MU_LAW = 7;
    private static final int GSM_FULL_RATE = 49;
    private static final int EXTENSIBLE = 0xFFFE;
    static final Encoding GSM = new Encoding("GSM 06.10");

    /**
     * The header in the first octets of a file, {@code head}'s remaining ones; the position of {@code head} does not
     * change. Empty for other files, for samples that begin after those octets, and for an unknown sample format.
     */
    static Optional<WavHeader> in(ByteBuffer head) {
        ByteBuffer octets = head.slice().order(ByteOrder.LITTLE_ENDIAN);
        if (octets.remaining() < 12) {
            return Optional.empty();
        }
        String container = id(octets);
        octets.getInt();
        if (!(container.equals("RIFF") || container.equals("RF64"))
                || !id(octets).equals("WAVE")) {
            return Optional.empty();
        }
        Optional<AudioFormat> format = Optional.empty();
        long longLength = UNKNOWN;
        while (octets.remaining() >= CHUNK_HEAD_OCTETS) {
            String chunk = id(octets);
            long length = octets.getInt() & UNKNOWN;
            if (chunk.equals("data")) {
                long whole = length == UNKNOWN ? longLength : length;
                return format.map(found -> new WavHeader(found, octets.position(), dataOctets(whole, octets)));
            }
            long next = octets.position() + length + (length & 1);
            if (next > octets.limit()) {
                return Optional.empty();
            }
            if (chunk.equals("fmt ")) {
                format = format(octets.slice(octets.position(), (int) length));
            } else if (chunk.equals("ds64") && length >= 16) {
                longLength = octets.getLong(octets.position() + 8);
            }
            octets.position((int) next);
        }
        return Optional.empty();
    }

    private static String id(ByteBuffer octets) {
        byte[] id = new byte[4];
        octets.get(id);
        return new String(id, StandardCharsets.ISO_8859_1);
    }

    private static long dataOctets(long length, ByteBuffer after) {
        boolean empty = length == 0 && (!after.hasRemaining() || beginsAChunk(after));
        boolean known = length > 0 && length != UNKNOWN;
        return known || empty ? length : Long.MAX_VALUE;
    }

    /** True if an empty data chunk is followed by another chunk, not by samples of unknown length. */
    private static boolean beginsAChunk(ByteBuffer after) {
        if (after.remaining() < CHUNK_HEAD_OCTETS) {
            return false;
        }
        for (int i = 0; i < 4; i++) {
            byte octet = after.get(after.position() + i);
            if (!(Character.isLetterOrDigit(octet) || octet == ' ')) {
                return false;
            }
        }
        return true;
    }

    private static Optional<AudioFormat> format(ByteBuffer chunk) {
        chunk.order(ByteOrder.LITTLE_ENDIAN);
        if (chunk.remaining() < 16) {
            return Optional.empty();
        }
        int tag = chunk.getShort(0) & 0xFFFF;
        int channels = chunk.getShort(2) & 0xFFFF;
        int rate = chunk.getInt(4);
        int bits = chunk.getShort(14) & 0xFFFF;
        if (tag == EXTENSIBLE) {
            tag = chunk.remaining() < 40 || !chunk.slice(26, 14).equals(ByteBuffer.wrap(GUID_END))
                    ? EXTENSIBLE
                    : chunk.getShort(24) & 0xFFFF;
        }
        if (tag == GSM_FULL_RATE && channels == 1 && rate == SpeechCodec.SAMPLES_PER_SECOND) {
            return Optional.of(new AudioFormat(GSM, rate, 0, 1, GsmSamples.WAV_BLOCK_OCTETS, rate, false));
        }
        Optional<Encoding> encoding = encoding(tag, bits);
        if (encoding.isEmpty() || channels == 0 || rate <= 0 || bits == 0 || bits > 64) {
            return Optional.empty();
        }
        // The frame size is computed, because its field is wrong in some files.
        int frameOctets = channels * ((bits + 7) / 8);
        return Optional.of(new AudioFormat(encoding.get(), rate, bits, channels, frameOctets, rate, false));
    }

    private static Optional<Encoding> encoding(int tag, int bits) {
        return switch (tag) {
            case PCM -> Optional.of(bits <= 8 ? Encoding.PCM_UNSIGNED : Encoding.PCM_SIGNED);
            case IEEE_FLOAT -> Optional.of(Encoding.PCM_FLOAT);
            case A_LAW -> Optional.of(Encoding.ALAW);
            case MU_LAW -> Optional.of(Encoding.ULAW);
            default -> Optional.empty();
        };
    }
}
