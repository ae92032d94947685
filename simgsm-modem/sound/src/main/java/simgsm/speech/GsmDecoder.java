package simgsm.speech;

/** GSM 06.10's receiving side (ETS 300 961, 5.3). */
final class GsmDecoder {
    private static final int SUBFRAME = 40;
    private static final int LONGEST_LAG = 120;

    private final GsmFrame frame = new GsmFrame();
    private final GsmPulses pulses = new GsmPulses();
    private final int[] reflection = new int[GsmRatios.ORDER];
    private final int[] lattice = new int[GsmRatios.ORDER + 1];
    /** The reconstructed residual: 120 samples past, then the 40 that are being made. */
    private final int[] residual = new int[LONGEST_LAG + SUBFRAME];

    private final int[] error = new int[SUBFRAME];
    private final int[] whole = new int[SpeechCodec.SAMPLES_PER_FRAME];
    private int[] ratios = new int[GsmRatios.ORDER];
    private int[] ratiosBefore = new int[GsmRatios.ORDER];
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

    /** 5.3.2; a lag out of range is a transmission error, the last one serves. */
    private void longTerm(int j) {
        if (frame.lag[j] >= SUBFRAME && frame.lag[j] <= LONGEST_LAG) {
            lag = frame.lag[j];
        }
        int gain = GsmEncoder.GAINS[frame.gain[j]];
        for (int k = 0; k < SUBFRAME; k++) {
            int past = residual[LONGEST_LAG + k - lag];
            residual[LONGEST_LAG + k] = Fixed.add(error[k], Fixed.multiplyRounded(gain, past));
        }
        System.arraycopy(residual, LONGEST_LAG, whole, j * SUBFRAME, SUBFRAME);
        System.arraycopy(residual, SUBFRAME, residual, 0, LONGEST_LAG);
    }

    /** The lattice filter's inverse, de-emphasis, and 13 bits out (5.3.4 to 5.3.7). */
    private short[] shortTerm() {
        int[] swap = ratiosBefore;
        ratiosBefore = ratios;
        ratios = swap;
        GsmRatios.decode(frame.ratios, ratios);
        short[] speech = new short[whole.length];
        for (int part = 0; part < 4; part++) {
            GsmRatios.between(ratiosBefore, ratios, part, reflection);
            for (int k = GsmRatios.PART_STARTS[part]; k < GsmRatios.PART_STARTS[part + 1]; k++) {
                emphasis = Fixed.add(synthesize(whole[k]), Fixed.multiplyRounded(emphasis, 28180));
                speech[k] = (short) (Fixed.add(emphasis, emphasis) & 0xFFF8);
            }
        }
        return speech;
    }

    private int synthesize(int value) {
        int out = value;
        for (int i = GsmRatios.ORDER - 1; i >= 0; i--) {
            out = Fixed.subtract(out, Fixed.multiplyRounded(reflection[i], lattice[i]));
            lattice[i + 1] = Fixed.add(lattice[i], Fixed.multiplyRounded(reflection[i], out));
        }
        lattice[0] = out;
        return out;
    }
}
