package simgsm.tools.load;

import java.util.Arrays;

/**
 * A number coded into a speech frame, one bit per sample as the sign of a loud sample, which survives every speech codec
 * that keeps such signs. Silence has no number.
 */
final class SpeechFrameNumber {
    /** No number: silence, or other speech. */
    static final int NONE = -1;

    /** The number after which 0 follows. */
    static final int LARGEST = 0xffff;

    private static final int BITS = 16;
    private static final short LOUD = 8_000;
    private static final short QUIET = 1_000;

    private SpeechFrameNumber() {}

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
