package simgsm.dtmf;

import java.util.Optional;

/**
 * What a tone scope shows, immutable: the last stretch of sound, the levels of the eight DTMF frequencies in it, and the
 * key that was heard or sent last. With an experiment all of it is what is heard of the disturbed sound.
 */
public final class ToneTrace {
    /** 40 ms at 8 kHz. */
    public static final int SAMPLES = 320;
    /** What silence is shown as. */
    public static final double FLOOR_DBM0 = -60;
    /** Fainter tones are no key's, whatever else they are (ITU-T Q.24: at -55 dBm0 nothing may be heard). */
    public static final double LEAST_DBM0 = -50;
    /** Greatest difference of the groups' levels, dB, at which the receiver examines them further. */
    public static final double MOST_TWIST_DECIBELS = 13;
    /** Greatest ratio of the sum of a group's four powers to the strongest one. */
    private static final double MOST_SPREAD = 1.6;
    /** Nothing has sounded yet. */
    public static final ToneTrace EMPTY =
            new ToneTrace(new short[SAMPLES], silence(), Optional.empty(), false, ToneExperiment.NONE, ToneScore.NONE);

    private final short[] samples;
    private final double[] levelsDbm0;
    private final Optional<DtmfDigit> digit;
    private final boolean sounding;
    private final ToneExperiment experiment;
    private final ToneScore score;

    ToneTrace(
            short[] samples,
            double[] levelsDbm0,
            Optional<DtmfDigit> digit,
            boolean sounding,
            ToneExperiment experiment,
            ToneScore score) {
        this.samples = samples;
        this.levelsDbm0 = levelsDbm0;
        this.digit = digit;
        this.sounding = sounding;
        this.experiment = experiment;
        this.score = score;
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

    /** What a row's tone has to reach now: not too far below the loudest column. */
    public double leastRowDbm0() {
        return least(4);
    }

    /** What a column's tone has to reach now: not too far below the loudest row. */
    public double leastColumnDbm0() {
        return least(0);
    }

    /** Whether a row's tone stands out: it reaches what it has to, and the other rows together do not come near it. */
    public boolean rowCounts(int row) {
        return counts(0, row, leastRowDbm0());
    }

    /** Whether a column's tone stands out. */
    public boolean columnCounts(int column) {
        return counts(4, column, leastColumnDbm0());
    }

    private boolean counts(int group, int index, double leastDbm0) {
        double together = 0;
        for (int i = group; i < group + 4; i++) {
            together += Math.pow(10, levelsDbm0[i] / 10);
        }
        double own = levelsDbm0[group + index];
        return own > leastDbm0 && together < MOST_SPREAD * Math.pow(10, own / 10);
    }

    private double least(int otherGroup) {
        double loudest = FLOOR_DBM0;
        for (int i = 0; i < 4; i++) {
            loudest = Math.max(loudest, levelsDbm0[otherGroup + i]);
        }
        return Math.max(LEAST_DBM0, loudest - MOST_TWIST_DECIBELS);
    }

    /** The key that was decided last. */
    public Optional<DtmfDigit> digit() {
        return digit;
    }

    /** Whether that key's tone still sounds. */
    public boolean isSounding() {
        return sounding;
    }

    /** What was done to the sound. */
    public ToneExperiment experiment() {
        return experiment;
    }

    /** How the experiment went since it was set; empty counts without one. */
    public ToneScore score() {
        return score;
    }
}
