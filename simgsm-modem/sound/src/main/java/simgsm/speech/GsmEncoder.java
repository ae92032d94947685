package simgsm.speech;

/** The GSM 06.10 encoder (ETS 300 961, 5.2). */
final class GsmEncoder {
    private static final int SUBFRAME = 40;
    private static final int LONGEST_LAG = 120;
    /** Decision levels and values of the long-term gain (table 5.3). */
    private static final int[] GAIN_LEVELS = {6554, 16384, 26214};

    static final int[] GAINS = {3277, 11469, 21299, 32767};

    private final int[] samples = new int[SpeechCodec.SAMPLES_PER_FRAME];
    private final GsmFrame frame = new GsmFrame();
    private final RegularPulseExcitation pulses = new RegularPulseExcitation();
    private final int[] reflection = new int[LogAreaRatios.ORDER];
    private final int[] lattice = new int[LogAreaRatios.ORDER];
    /** The reconstructed short-term residual: 120 past samples, then the 40 of the current subframe. */
    private final int[] residual = new int[LONGEST_LAG + SUBFRAME];

    private final int[] prediction = new int[SUBFRAME];
    private final int[] error = new int[SUBFRAME];
    private final int[] scaled = new int[SUBFRAME];
    private int[] ratios = new int[LogAreaRatios.ORDER];
    private int[] ratiosBefore = new int[LogAreaRatios.ORDER];
    private int offsetInput;
    private int offsetOutput;
    private int emphasisInput;

    byte[] encode(short[] speech) {
        prepare(speech);
        LogAreaRatios.code(samples, frame.ratios);
        shortTerm();
        for (int j = 0; j < GsmFrame.SUBFRAMES; j++) {
            longTerm(j);
            pulses.code(error, frame, j);
            pulses.decode(frame, j, error);
            System.arraycopy(residual, SUBFRAME, residual, 0, LONGEST_LAG - SUBFRAME);
            for (int k = 0; k < SUBFRAME; k++) {
                residual[LONGEST_LAG - SUBFRAME + k] = FixedPoint.add(error[k], prediction[k]);
            }
        }
        return frame.pack();
    }

    /** Scaling to 13 bits, offset compensation and pre-emphasis (5.2.1 to 5.2.3). */
    private void prepare(short[] speech) {
        for (int k = 0; k < samples.length; k++) {
            int input = speech[k] >> 3 << 2;
            int change = input - offsetInput;
            offsetInput = input;
            int high = offsetOutput >> 15;
            int low = offsetOutput - (high << 15);
            long sum = ((long) change << 15) + FixedPoint.multiplyRounded(low, 32735) + high * 32735L;
            offsetOutput = clamp(sum);
            int emphasis = FixedPoint.multiplyRounded(emphasisInput, -28180);
            emphasisInput = clamp(offsetOutput + 16384L) >> 15;
            samples[k] = FixedPoint.add(emphasisInput, emphasis);
        }
    }

    private static int clamp(long value) {
        return (int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, value));
    }

    /** Replaces the samples by the residual of the lattice filter (5.2.8 to 5.2.10). */
    private void shortTerm() {
        int[] swap = ratiosBefore;
        ratiosBefore = ratios;
        ratios = swap;
        LogAreaRatios.decode(frame.ratios, ratios);
        for (int part = 0; part < 4; part++) {
            LogAreaRatios.between(ratiosBefore, ratios, part, reflection);
            for (int k = LogAreaRatios.PART_STARTS[part]; k < LogAreaRatios.PART_STARTS[part + 1]; k++) {
                samples[k] = analyse(samples[k]);
            }
        }
    }

    private int analyse(int sample) {
        int forward = sample;
        int save = sample;
        for (int i = 0; i < LogAreaRatios.ORDER; i++) {
            int backward = lattice[i];
            lattice[i] = save;
            save = FixedPoint.add(backward, FixedPoint.multiplyRounded(reflection[i], forward));
            forward = FixedPoint.add(forward, FixedPoint.multiplyRounded(reflection[i], backward));
        }
        return forward;
    }

    /** Finds lag and gain of the best long-term prediction of subframe j; sets prediction and error (5.2.11, 5.2.12). */
    private void longTerm(int j) {
        int from = j * SUBFRAME;
        int peak = 0;
        for (int k = 0; k < SUBFRAME; k++) {
            peak = Math.max(peak, FixedPoint.absolute(samples[from + k]));
        }
        int scale = peak == 0 ? 0 : Math.max(0, 6 - FixedPoint.headroom(peak << 16));
        for (int k = 0; k < SUBFRAME; k++) {
            scaled[k] = samples[from + k] >> scale;
        }
        int most = 0;
        int lag = SUBFRAME;
        for (int candidate = SUBFRAME; candidate <= LONGEST_LAG; candidate++) {
            float sum = correlation(candidate);
            if (sum > most) {
                most = (int) sum;
                lag = candidate;
            }
        }
        frame.lag[j] = lag;
        frame.gain[j] = gain(most << 1 >> 6 - scale, lag);
        int gain = GAINS[frame.gain[j]];
        for (int k = 0; k < SUBFRAME; k++) {
            prediction[k] = FixedPoint.multiplyRounded(gain, residual[LONGEST_LAG + k - lag]);
            error[k] = FixedPoint.subtract(samples[from + k], prediction[k]);
        }
    }

    /**
     * Cross-correlation in single precision, as in libgsm: if sums exceed 24 bits, on the loudest periodic signals,
     * several lags have equal sums, and the first is used.
     */
    private float correlation(int lag) {
        float sum = 0;
        for (int k = 0; k < SUBFRAME; k++) {
            sum += (float) scaled[k] * residual[LONGEST_LAG + k - lag];
        }
        return sum;
    }

    private int gain(int correlation, int lag) {
        int power = 0;
        for (int k = 0; k < SUBFRAME; k++) {
            int past = residual[LONGEST_LAG + k - lag] >> 3;
            power += past * past;
        }
        power <<= 1;
        if (correlation <= 0) {
            return 0;
        }
        if (correlation >= power) {
            return 3;
        }
        int shift = FixedPoint.headroom(power);
        int r = correlation << shift >> 16;
        int s = power << shift >> 16;
        int index = 0;
        while (index < GAIN_LEVELS.length && r > FixedPoint.multiply(s, GAIN_LEVELS[index])) {
            index++;
        }
        return index;
    }
}
