package simgsm.dtmf;

/**
 * What speaks for and against two tones' being a key's: how they sound and what else sounds beside them. Measured in two
 * steps, since most keys come alone in the line and need no spectrum.
 */
final class ToneEvidence {
    /** So soon after the estimated beginning the time before it ends: 1 ms. */
    private static final int MARGIN = 8;
    /** Share by which the ratio of two harmonics' frequencies, as measured, may miss that of their numbers. */
    private static final double SAME_VOICE = 0.002;
    /** The row's tone is looked for up to this harmonic; higher ones lie too close to be told apart. */
    private static final int HIGHEST_ROW = 6;
    /** Up to this harmonic of the row's tone a voice's harmonics lie seven bins of the spectrum apart. */
    private static final int FAR_APART = 3;

    final Residue residue = new Residue();

    ToneFit fit;
    /** A key sounds or has sounded just before. */
    boolean followsKey;
    /** The larger frequency error, in percent. */
    double error;
    /** The smaller coherence of the two. */
    double coherence;
    /** The larger ripple of the two. */
    double ripple;
    /** In decibels, high group over low. */
    double twist;
    /** Level of the weaker tone. */
    double weakerDbm0;

    /** Shares are of power: the tones' in all that sounds, over all frequencies. */
    double shareOfAll;
    /** The same, what was heard before left aside. */
    double newShareOfAll;
    /** All that sounded before they began, against the tones. */
    double allBefore;

    /** The tones' in all that sounds between 560 and 3500 Hz. */
    double share;
    /** The same, what was heard before left aside. */
    double newShare;
    /** At the tones' frequencies before they began, against the tones. */
    double tonesBefore;
    /** Elsewhere in the band before they began, against the tones. */
    double restBefore;
    /** The strongest line beside the tones, in decibels against the weaker tone. */
    double line;
    /** The strongest line that was not there before. */
    double newLine;
    /** The strongest line's share of all that sounds in the band beside the tones; near 0 for noise. */
    double lineShare;

    private short[] samples;
    private int end;
    private int onset;
    private double tones;
    private double weaker;
    private int rowMultiple;
    private int columnMultiple;

    /** @param end index just behind the newest sample */
    void measure(ToneFit toneFit, short[] line, int newestEnd, boolean afterKey) {
        fit = toneFit;
        samples = line;
        end = newestEnd;
        followsKey = afterKey;
        error = 100 * Math.max(Math.abs(fit.error[0]), Math.abs(fit.error[1]));
        coherence = Math.min(fit.coherence[0], fit.coherence[1]);
        ripple = Math.max(fit.ripple[0], fit.ripple[1]);
        tones = square(fit.amplitude[0]) + square(fit.amplitude[1]);
        weaker = Math.min(square(fit.amplitude[0]), square(fit.amplitude[1]));
        twist = fit.twist();
        findHarmony();
        onset = (int) (end - ToneBank.HOP * (fit.sinceOnset + 1)) - MARGIN;
    }

    void measureLevels() {
        double all = 2 * power(onset + MARGIN, end);
        double before = 2 * power(onset - Residue.LENGTH, onset);
        shareOfAll = tones / all;
        newShareOfAll = tones / (tones + Math.max(0, all - tones - 1.2 * before));
        allBefore = before / tones;
    }

    void measureSpectrum() {
        residue.measure(samples, end, onset, fit.hertz[0], fit.hertz[1]);
        share = tones / (tones + residue.rest);
        newShare = tones / (tones + Math.max(0, residue.rest - 1.3 * residue.restBefore));
        tonesBefore = (residue.rowBefore + residue.columnBefore) / tones;
        restBefore = residue.restBefore / tones;
        line = decibels(residue.line / weaker);
        newLine = decibels(residue.newLine / weaker);
        lineShare = residue.line / residue.rest;
        weakerDbm0 = ToneLevel.dbm0(Math.min(fit.amplitude[0], fit.amplitude[1]));
    }

    /** The tones did not sound before, or a key did just then, whose tones explain it. */
    boolean isFresh() {
        return followsKey || tonesBefore < 0.06;
    }

    /** What sounded before they began was not much louder than what sounds beside them now. */
    boolean isStationary() {
        return residue.restBefore < 1.8 * residue.rest && allBefore < 1.6 * (1 / shareOfAll - 0.8);
    }

    /** The tones' frequencies are to each other as two of a voice's lower harmonics are. */
    boolean isHarmony() {
        return rowMultiple > 0;
    }

    /** The strongest other harmonic of the voice of which the tones would be two, in decibels against the weaker tone. */
    double family() {
        double hertz = (fit.hertz[0] + fit.hertz[1]) / (rowMultiple + columnMultiple);
        return decibels(residue.family(hertz, rowMultiple, columnMultiple) / weaker);
    }

    /** What sounds beside the tones is mostly that voice's other harmonics; told only if they lie far apart. */
    boolean isFamily() {
        double hertz = (fit.hertz[0] + fit.hertz[1]) / (rowMultiple + columnMultiple);
        return rowMultiple <= FAR_APART && residue.familyShare(hertz) > 0.6;
    }

    private void findHarmony() {
        double ratio = fit.hertz[1] / fit.hertz[0];
        for (rowMultiple = HIGHEST_ROW; rowMultiple > 0; rowMultiple--) {
            columnMultiple = (int) Math.round(ratio * rowMultiple);
            if (Math.abs(ratio * rowMultiple / columnMultiple - 1) < SAME_VOICE) {
                return;
            }
        }
    }

    /** Tones far off their frequency, up to 2.1 %, are taken only if all else is as it should be. */
    boolean isSteadyAndNew() {
        return fit.sinceOnset < 14 && ripple < 1.2;
    }

    /** A tone's frequency before it began, against the tone. */
    double before(int tone) {
        return (tone == 0 ? residue.rowBefore : residue.columnBefore) / square(fit.amplitude[tone]);
    }

    /** The tone wavers no more than the noise beside it makes it. */
    boolean isExplainedByNoise(int tone) {
        double inBand = ToneBank.NOISE_SHARE * residue.rest;
        return 1 - fit.coherence[tone] < 0.06 + 2.2 * inBand / square(fit.amplitude[tone]);
    }

    private static double square(double x) {
        return x * x;
    }

    private static double decibels(double ratio) {
        return 10 * Math.log10(Math.max(1e-12, ratio));
    }

    /** Mean square. */
    private double power(int from, int to) {
        long sum = 0;
        int first = Math.max(0, from);
        for (int i = first; i < to; i++) {
            sum += samples[i] * samples[i];
        }
        return sum / (double) Math.max(1, to - first);
    }
}
