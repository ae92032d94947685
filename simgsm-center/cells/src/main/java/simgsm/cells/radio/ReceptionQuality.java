package simgsm.cells.radio;

/**
 * Bit and block errors at a level and an interference.
 *
 * <p>The bit error rate before decoding is that of minimum shift keying in Rayleigh fading, (1 - sqrt(g / (1 + g))) /
 * 2, with g shifted so that 9 dB yield 8 %, as TS 45.005, table 1, requires at the reference level of -102 dBm (TU50,
 * class II bits). There 6 % of the speech frames and 13 % of the signalling blocks are erased; the curves through these
 * points are ours.
 */
public final class ReceptionQuality {
    /** Carrier to noise or interference at the reference sensitivity (TS 45.005, 6.3: C/Ic = 9 dB). */
    public static final double REFERENCE_DECIBELS = 9;
    /** The reference level of a handset of GSM 900 (TS 45.005, 6.2). */
    public static final double REFERENCE_DBM = -102;
    /** Noise of the receiver, consistent with both references. */
    public static final double NOISE_DBM = REFERENCE_DBM - REFERENCE_DECIBELS;
    /** Attenuation of a neighbour on the adjacent channel, 200 kHz away (TS 45.005, 6.3: C/Ia1 = -9 dB). */
    public static final double ADJACENT_DECIBELS = 18;

    /** (1 - sqrt(g / (1 + g))) / 2 is 8 % at g = 3.80 dB. */
    private static final double SHIFT_DECIBELS = REFERENCE_DECIBELS - 3.80;

    /** Bit error rates in percent, and the speech frames erased there. */
    private static final double[][] SPEECH = {
        {2, 0}, {4, 0.002}, {6.4, 0.02}, {8, 0.06}, {10, 0.16}, {12.8, 0.45}, {16, 0.8}, {20, 0.98}, {25, 1}
    };

    private static final double[][] SIGNALLING = {
        {2, 0}, {4, 0.01}, {6.4, 0.06}, {8, 0.13}, {10, 0.26}, {12.8, 0.55}, {16, 0.85}, {20, 0.98}, {25, 1}
    };

    private ReceptionQuality() {}

    /** A level as power in milliwatts. */
    public static double milliwatts(double dbm) {
        return Math.pow(10, dbm / 10);
    }

    /**
     * The carrier over noise and interference in dB.
     *
     * @param interferenceMilliwatts sum of other transmitters on the channel; 0 for none
     */
    public static double carrierDecibels(double carrierDbm, double interferenceMilliwatts) {
        return carrierDbm - 10 * Math.log10(milliwatts(NOISE_DBM) + interferenceMilliwatts);
    }

    /** The bit error rate before decoding, 0 to 0.5. @param carrierDecibels carrier over noise and interference */
    public static double bitErrorRate(double carrierDecibels) {
        double g = Math.pow(10, (carrierDecibels - SHIFT_DECIBELS) / 10);
        return (1 - Math.sqrt(g / (1 + g))) / 2;
    }

    /** The share of erased speech frames at a bit error rate, 0 to 1. */
    public static double frameErasureRate(double bitErrorRate) {
        return between(SPEECH, bitErrorRate);
    }

    /** The share of lost signalling blocks (SACCH, SDCCH) at a bit error rate, 0 to 1. */
    public static double blockErasureRate(double bitErrorRate) {
        return between(SIGNALLING, bitErrorRate);
    }

    private static double between(double[][] points, double bitErrorRate) {
        double percent = bitErrorRate * 100;
        if (percent <= points[0][0]) {
            return points[0][1];
        }
        for (int i = 1; i < points.length; i++) {
            if (percent <= points[i][0]) {
                double share = (percent - points[i - 1][0]) / (points[i][0] - points[i - 1][0]);
                return points[i - 1][1] + share * (points[i][1] - points[i - 1][1]);
            }
        }
        return 1;
    }
}
