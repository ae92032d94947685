package simgsm.speech;

/**
 * The 76 parameters of one 20 ms frame (ETS 300 961, table 1.1), and its 33 octets: the signature 0xD in
 * four bits, then each parameter with its most significant bit first (RFC 3551, 4.5.8).
 */
final class GsmFrame {
    static final int OCTETS = 33;
    static final int SUBFRAMES = 4;
    static final int PULSES = 13;
    private static final int BITS = 260;
    private static final int SIGNATURE = 0xD;
    private static final int[] RATIO_BITS = {6, 6, 5, 5, 4, 4, 3, 3};

    /** LARc: the coded log area ratios. */
    final int[] ratios = new int[8];
    /** Nc: long-term lag, 40 to 120 samples. */
    final int[] lag = new int[SUBFRAMES];
    /** bc: index of the long-term gain. */
    final int[] gain = new int[SUBFRAMES];
    /** Mc: grid position of the pulses. */
    final int[] grid = new int[SUBFRAMES];
    /** xmaxc: coded largest pulse. */
    final int[] largest = new int[SUBFRAMES];
    /** xMc: coded pulses. */
    final int[][] pulses = new int[SUBFRAMES][PULSES];

    private byte[] octets;
    private int bit;
    private boolean leastFirst;

    byte[] pack() {
        octets = new byte[OCTETS];
        bit = 0;
        put(SIGNATURE, 4);
        for (int i = 0; i < 8; i++) {
            put(ratios[i], RATIO_BITS[i]);
        }
        for (int j = 0; j < SUBFRAMES; j++) {
            put(lag[j], 7);
            put(gain[j], 2);
            put(grid[j], 2);
            put(largest[j], 6);
            for (int i = 0; i < PULSES; i++) {
                put(pulses[j][i], 3);
            }
        }
        return octets;
    }

    void unpack(byte[] from) {
        if (from.length != OCTETS || (from[0] >> 4 & 15) != SIGNATURE) {
            throw new IllegalArgumentException("No GSM 06.10 frame (expected 33 octets, the first 0xD0 to 0xDF)");
        }
        octets = from;
        bit = 4;
        takeAll();
    }

    /**
     * The 33 octets of a frame of a WAV file (tag 49): two frames in 65 octets, without signature, each parameter and octet with
     * its least significant bit first.
     *
     * @param index 0 or 1
     */
    static byte[] ofWav(byte[] block, int index) {
        GsmFrame frame = new GsmFrame();
        frame.octets = block;
        frame.bit = BITS * index;
        frame.leastFirst = true;
        frame.takeAll();
        return frame.pack();
    }

    private void takeAll() {
        for (int i = 0; i < 8; i++) {
            ratios[i] = take(RATIO_BITS[i]);
        }
        for (int j = 0; j < SUBFRAMES; j++) {
            lag[j] = take(7);
            gain[j] = take(2);
            grid[j] = take(2);
            largest[j] = take(6);
            for (int i = 0; i < PULSES; i++) {
                pulses[j][i] = take(3);
            }
        }
    }

    private void put(int value, int bits) {
        for (int i = bits - 1; i >= 0; i--, bit++) {
            octets[bit >> 3] |= (byte) ((value >> i & 1) << 7 - (bit & 7));
        }
    }

    private int take(int bits) {
        int value = 0;
        for (int i = 0; i < bits; i++, bit++) {
            int octet = octets[bit >> 3];
            value = leastFirst ? value | (octet >> (bit & 7) & 1) << i : value << 1 | octet >> 7 - (bit & 7) & 1;
        }
        return value;
    }
}
