package simgsm.speech;

/** G.711: logarithmic companding of each sample to one octet. Has no state, so one instance serves all calls. */
public final class G711 implements SpeechCodec {
    public static final G711 A_LAW = new G711(Kind.A_LAW);
    public static final G711 MU_LAW = new G711(Kind.MU_LAW);

    private final Kind kind;
    private final short[] toLinear = new short[256];
    /** By sample, as unsigned 16 bits. */
    private final byte[] toOctet = new byte[65536];

    private G711(Kind kind) {
        this.kind = kind;
        for (int octet = 0; octet < 256; octet++) {
            toLinear[octet] = (short) (kind == Kind.A_LAW ? expandALaw(octet) : expandMuLaw(octet));
        }
        for (int sample = Short.MIN_VALUE; sample <= Short.MAX_VALUE; sample++) {
            toOctet[sample & 0xFFFF] = (byte) (kind == Kind.A_LAW ? compressALaw(sample) : compressMuLaw(sample));
        }
    }

    @Override
    public Kind kind() {
        return kind;
    }

    @Override
    public byte[] encode(short[] frame) {
        if (frame.length != SAMPLES_PER_FRAME) {
            throw new IllegalArgumentException("Frame of " + frame.length + " samples (expected 160)");
        }
        byte[] octets = new byte[SAMPLES_PER_FRAME];
        for (int i = 0; i < octets.length; i++) {
            octets[i] = toOctet[frame[i] & 0xFFFF];
        }
        return octets;
    }

    @Override
    public short[] decode(byte[] octets) {
        if (octets.length != SAMPLES_PER_FRAME) {
            throw new IllegalArgumentException("Frame of " + octets.length + " octets (expected 160)");
        }
        short[] frame = new short[SAMPLES_PER_FRAME];
        for (int i = 0; i < frame.length; i++) {
            frame[i] = toLinear[octets[i] & 0xFF];
        }
        return frame;
    }

    /** The 16-bit sample of an octet. */
    public short expand(byte octet) {
        return toLinear[octet & 0xFF];
    }

    /** Table 1 of G.711 scaled to 16 bits: sign (1 is positive), 3 bits of segment, 4 of step, even bits inverted. */
    private static int expandALaw(int octet) {
        int code = octet ^ 0x55;
        int segment = code >> 4 & 7;
        int step = code & 15;
        int magnitude = segment == 0 ? 16 * step + 8 : 16 * step + 264 << segment - 1;
        return (code & 0x80) != 0 ? magnitude : -magnitude;
    }

    private static int compressALaw(int sample) {
        // A-law has 13 bits; rounding down makes the negative half a mirror image of the positive one.
        int magnitude = sample >= 0 ? sample >> 3 : ~sample >> 3;
        int segment = Math.max(0, 27 - Integer.numberOfLeadingZeros(magnitude | 1));
        int step = magnitude >> Math.max(segment, 1) & 15;
        return ((sample >= 0 ? 0x80 : 0) | segment << 4 | step) ^ 0x55;
    }

    /** Table 2 of G.711 scaled to 16 bits, all bits inverted; 33 is the bias of the 14-bit scale. */
    private static int expandMuLaw(int octet) {
        int code = ~octet & 0xFF;
        int magnitude = ((2 * (code & 15) + 33 << (code >> 4 & 7)) - 33) * 4;
        return (code & 0x80) != 0 ? -magnitude : magnitude;
    }

    private static int compressMuLaw(int sample) {
        int magnitude = Math.min((sample >= 0 ? sample : ~sample) >> 2, 8158) + 33;
        int segment = 26 - Integer.numberOfLeadingZeros(magnitude);
        int step = magnitude >> segment + 1 & 15;
        return ~((sample < 0 ? 0x80 : 0) | segment << 4 | step) & 0xFF;
    }
}
