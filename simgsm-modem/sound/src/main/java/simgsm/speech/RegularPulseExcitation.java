package simgsm.speech;

/** RPE: the prediction error, decimated to every third sample (ETS 300 961, 5.2.13 to 5.2.17). */
final class RegularPulseExcitation {
    private static final int LENGTH = 40;
    private static final int[] WEIGHTS = {-134, -374, 0, 2054, 5741, 8192, 5741, 2054, 0, -374, -134};
    private static final int[] INVERSE_MANTISSA = {29128, 26215, 23832, 21846, 20165, 18725, 17476, 16384};
    private static final int[] MANTISSA = {18431, 20479, 22527, 24575, 26623, 28671, 30719, 32767};

    private final int[] padded = new int[LENGTH + 10];
    private final int[] weighted = new int[LENGTH];
    private int exponent;
    private int mantissa;

    /** Codes the error {@code e} into the frame's subframe j. */
    void code(int[] e, GsmFrame frame, int j) {
        weigh(e);
        frame.grid[j] = grid();
        quantize(frame, j);
    }

    private void weigh(int[] e) {
        System.arraycopy(e, 0, padded, 5, LENGTH);
        for (int k = 0; k < LENGTH; k++) {
            int sum = 4096;
            for (int i = 0; i < WEIGHTS.length; i++) {
                sum += padded[k + i] * WEIGHTS[i];
            }
            weighted[k] = FixedPoint.saturate(sum >> 13);
        }
    }

    private int grid() {
        int best = 0;
        int most = 0;
        for (int m = 0; m < 4; m++) {
            int energy = 0;
            for (int i = 0; i < GsmFrame.PULSES; i++) {
                int pulse = weighted[m + 3 * i] >> 2;
                energy += pulse * pulse;
            }
            if (energy > most) {
                most = energy;
                best = m;
            }
        }
        return best;
    }

    private void quantize(GsmFrame frame, int j) {
        int start = frame.grid[j];
        int largest = 0;
        for (int i = 0; i < GsmFrame.PULSES; i++) {
            largest = Math.max(largest, FixedPoint.absolute(weighted[start + 3 * i]));
        }
        int magnitude = 0;
        for (int rest = largest >> 9; rest > 0 && magnitude < 6; rest >>= 1) {
            magnitude++;
        }
        frame.largest[j] = FixedPoint.add(largest >> magnitude + 5, magnitude << 3);
        split(frame.largest[j]);
        for (int i = 0; i < GsmFrame.PULSES; i++) {
            int pulse = (short) (weighted[start + 3 * i] << 6 - exponent);
            frame.pulses[j][i] = (FixedPoint.multiply(pulse, INVERSE_MANTISSA[mantissa]) >> 12) + 4;
        }
    }

    /** The coded largest pulse as exponent and mantissa. */
    private void split(int largest) {
        exponent = largest > 15 ? (largest >> 3) - 1 : 0;
        mantissa = largest - (exponent << 3);
        if (mantissa == 0) {
            exponent = -4;
            mantissa = 7;
            return;
        }
        while (mantissa <= 7) {
            mantissa = mantissa << 1 | 1;
            exponent--;
        }
        mantissa -= 8;
    }

    /** The error as reconstructed by the decoder. */
    void decode(GsmFrame frame, int j, int[] e) {
        split(frame.largest[j]);
        int shift = 6 - exponent;
        int half = shift == 0 ? 0 : 1 << shift - 1;
        java.util.Arrays.fill(e, 0);
        for (int i = 0; i < GsmFrame.PULSES; i++) {
            int pulse = 2 * frame.pulses[j][i] - 7 << 12;
            pulse = FixedPoint.add(FixedPoint.multiplyRounded(MANTISSA[mantissa], pulse), half);
            e[frame.grid[j] + 3 * i] = pulse >> shift;
        }
    }
}
