package simgsm.cells.cipher;

/** The key stream of A5/1: three shift registers; each whose clock bit has the majority of three is clocked. */
final class A51 {
    private static final int[] LENGTHS = {19, 22, 23};
    /** Bits that feed the register, as a mask. */
    private static final int[] TAPS = {0x072000, 0x300000, 0x700080};

    private static final int[] CLOCK_BITS = {8, 10, 10};
    private static final int COUNT_BITS = 22;
    private static final int MIXING_STEPS = 100;

    private final int[] registers = new int[LENGTHS.length];

    private A51() {}

    /**
     * The first bits of the stream.
     *
     * @param kc 64 bits; @param count the 22 bits of the frame's number as T1, T3 and T2
     */
    static byte[] stream(byte[] kc, int count, int length) {
        A51 state = new A51();
        for (int i = 0; i < kc.length * Byte.SIZE; i++) {
            state.load(kc[kc.length - 1 - i / Byte.SIZE] >> i % Byte.SIZE & 1);
        }
        for (int i = 0; i < COUNT_BITS; i++) {
            state.load(count >> i & 1);
        }
        for (int i = 0; i < MIXING_STEPS; i++) {
            state.step();
        }
        byte[] bits = new byte[length];
        for (int i = 0; i < length; i++) {
            bits[i] = (byte) state.step();
        }
        return bits;
    }

    private void load(int bit) {
        for (int r = 0; r < registers.length; r++) {
            clock(r, bit);
        }
    }

    private void clock(int r, int bit) {
        int feedback = Integer.bitCount(registers[r] & TAPS[r]) & 1 ^ bit;
        registers[r] = (registers[r] << 1 | feedback) & (1 << LENGTHS[r]) - 1;
    }

    private int clockBit(int r) {
        return registers[r] >> CLOCK_BITS[r] & 1;
    }

    private int step() {
        int majority = clockBit(0) + clockBit(1) + clockBit(2) >> 1;
        int out = 0;
        for (int r = 0; r < registers.length; r++) {
            if (clockBit(r) == majority) {
                clock(r, 0);
            }
            out ^= registers[r] >> LENGTHS[r] - 1;
        }
        return out;
    }
}
