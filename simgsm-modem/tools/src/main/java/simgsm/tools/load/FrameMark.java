package simgsm.tools.load;

import java.util.Arrays;

/**
 * A number hidden in a speech frame, a bit a sample, so plainly that any codec that keeps the sign of a loud sample keeps
 * it. Silence carries none.
 */
final class FrameMark {
    /** No number: silence, or somebody else's speech. */
    static final int NONE = -1;

    /** Numbers count up to this one and begin again. */
    static final int LARGEST = 0xffff;

    private static final int BITS = 16;
    private static final short LOUD = 8_000;
    private static final short QUIET = 1_000;

    private FrameMark() {}

    static void put(short[] frame, int number) {
        Arrays.fill(frame, (short) 0);
        for (int bit = 0; bit < BITS; bit++) {
            frame[bit] = (number >> bit & 1) == 1 ? LOUD : -LOUD;
        }
    }

    static int read(short[] frame) {
        int number = 0;
        for (int bit = 0; bit < BITS; bit++) {
            if (Math.abs(frame[bit]) < QUIET) {
                return NONE;
            }
            number |= frame[bit] > 0 ? 1 << bit : 0;
        }
        return number;
    }
}
