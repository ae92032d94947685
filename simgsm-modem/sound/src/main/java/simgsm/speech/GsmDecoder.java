package simgsm.speech;

/** The GSM 06.10 decoder (ETS 300 961, 5.3). */
final class GsmDecoder {
    private static final int SUBFRAME = 40;
    private static final int LONGEST_LAG = 120;

    private final GsmFrame frame = new GsmFrame();
    private final RegularPulseExcitation pulses = new RegularPulseExcitation();
    private final int[] reflection = new int[LogAreaRatios.ORDER];
    private final int[] lattice = new int[LogAreaRatios.ORDER + 1];
    /** The reconstructed residual: 120 past samples, then the 40 of the current subframe. */
    private final int[] residual = new int[LONGEST_LAG + SUBFRAME];

    private final int[] error = new int[SUBFRAME];
    private final int[] whole = new int[SpeechCodec.SAMPLES_PER_FRAME];
    private int[] ratios = new int[LogAreaRatios.ORDER];
    private int[] ratiosBefore = new int[LogAreaRatios.ORDER];
    private int lag = SUBFRAME;
    private int emphasis;

    short[] decode(byte[] octets) {
        frame.unpack(octets);
        for (int j = 0; j < GsmFrame.SUBFRAMES; j++) {
            pulses.decode(frame, j, error);
            longTerm(j);
        }
        return shortTerm();
    }

    /** Long-term synthesis (5.3.2); a lag out of range is a transmission error and is replaced by the last one. */
    private void longTerm(int j) {
        if (frame.lag[j] >= SUBFRAME && frame.lag[j] <= LONGEST_LAG) {
            lag = frame.lag[j];
        }
        int gain = GsmEncoder.GAINS[frame.gain[j]];
        for (int k = 0; k < SUBFRAME; k++) {
            int past = residual[LONGEST_LAG + k - lag];
            residual[LONGEST_LAG + k] = FixedPoint.add(error[k], FixedPoint.multiplyRounded(gain, past));
        }
        System.arraycopy(residual, LONGEST_LAG, whole, j * SUBFRAME, SUBFRAME);
        System.arraycopy(residual, SUBFRAME, residual, 0, LONGEST_LAG);
    }

    /** Inverse lattice filter, de-emphasis, truncation to 13 bits (5.3.4 to 5.3.7). */
    private short[] shortTerm() {
        int[] swap = ratiosBefore;
        ratiosBefore = ratios;
        ratios = swap;
        LogAreaRatios.decode(frame.ratios, ratios);
        short[] speech = new short[whole.length];
        for (int part = 0; part < 4; part++) {
            LogAreaRatios.between(ratiosBefore, ratios, part, reflection);
            for (int k = LogAreaRatios.PART_STARTS[part]; k < LogAreaRatios.PART_STARTS[part + 1]; k++) {
                emphasis = FixedPoint.add(synthesize(whole[k]), FixedPoint.multiplyRounded(emphasis, 28180));
                speech[k] = (short) (FixedPoint.add(emphasis, emphasis) & 0xFFF8);
            }
        }
        return speech;
    }

    private int synthesize(int value) {
        int out = value;
        for (int i = LogAreaRatios.ORDER - 1; i >= 0; i--) {
            out = FixedPoint.subtract(out, FixedPoint.multiplyRounded(reflection[i], lattice[i]));
            lattice[i + 1] = FixedPoint.add(lattice[i], FixedPoint.multiplyRounded(reflection[i], out));
        }
        lattice[0] = out;
        return out;
    }
}
