package simgsm.dtmf;

import java.util.Optional;

/**
 * What a tone scope shows, immutable: the last stretch of sound, the levels of the eight DTMF frequencies in it, and the
 * key that was heard or sent last.
 */
public final class ToneTrace {
    /** 40 ms at 8 kHz. */
    public static final int SAMPLES = 320;
    /** What silence is shown as. */
    public static final double FLOOR_DBM0 = -60;
    /** Nothing has sounded yet. */
    public static final ToneTrace EMPTY = new ToneTrace(new short[SAMPLES], silence(), Optional.empty(), false);

    private final short[] samples;
    private final double[] levelsDbm0;
    private final Optional<DtmfDigit> digit;
    private final boolean sounding;

    ToneTrace(short[] samples, double[] levelsDbm0, Optional<DtmfDigit> digit, boolean sounding) {
        this.samples = samples;
        this.levelsDbm0 = levelsDbm0;
        this.digit = digit;
        this.sounding = sounding;
    }

    private static double[] silence() {
        double[] levels = new double[8];
        java.util.Arrays.fill(levels, FLOOR_DBM0);
        return levels;
    }

    /** A sample, oldest first. @param index 0 to {@link #SAMPLES} - 1 */
    public short sample(int index) {
        return samples[index];
    }

    /** Level of a row's frequency, 0 (697 Hz) to 3 (941 Hz). */
    public double rowDbm0(int row) {
        return levelsDbm0[row];
    }

    /** Level of a column's frequency, 0 (1209 Hz) to 3 (1633 Hz). */
    public double columnDbm0(int column) {
        return levelsDbm0[4 + column];
    }

    /** The key that was decided last. */
    public Optional<DtmfDigit> digit() {
        return digit;
    }

    /** Whether that key's tone still sounds. */
    public boolean isSounding() {
        return sounding;
    }
}
