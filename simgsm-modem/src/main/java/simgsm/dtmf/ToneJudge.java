package simgsm.dtmf;

/** Decides whether two tones that stand out are a key's, from how they sound and what else sounds beside them. */
final class ToneJudge {
    final Residue residue = new Residue();

    private static double square(double x) {
        return x * x;
    }

    /** @param end just behind the newest sample */
    boolean accepts(ToneFit fit, short[] samples, int end, boolean afterKey) {
        return !reason(fit, samples, end, afterKey).isEmpty();
    }

    /** The name of the rule that accepts; empty if none does. */
    private String reason(ToneFit fit, short[] samples, int end, boolean afterKey) {
        double e = 100 * fit.worstError();
        double coh = fit.worstCoherence();
        if (e > 2.4
                || coh < 0.35
                || fit.open && fit.sinceOnset >= ToneFit.SPAN - 2
                || coh < 0.9 && fit.sinceOnset < 11
                || coh < 0.75 && fit.sinceOnset < 12) {
            return "";
        }
        double rowHertz = fit.hertz[0];
        double columnHertz = fit.hertz[1];
        if (Math.abs(columnHertz / rowHertz - 2) < 0.003) {
            return "";
        }
        int onset = (int) (end - ToneBank.HOP * (fit.sinceOnset + 1)) - 8;
        double tones = square(fit.amplitude[0]) + square(fit.amplitude[1]);
        double rip = Math.max(fit.ripple[0], fit.ripple[1]);
        int length = (int) (ToneBank.HOP * (fit.sinceOnset + 1));
        double all = 2 * power(samples, end - length, end);
        double allBefore = 2 * power(samples, onset - Residue.LENGTH, onset);
        if (tones > 0.93 * all
                && coh > 0.975
                && rip < 1.35
                && (afterKey || allBefore < 0.06 * tones)
                && (e < 1.2 || fit.sinceOnset < 14 && rip < 1.2)) {
            return "quick";
        }
        residue.measure(samples, end, onset, rowHertz, columnHertz);
        double weaker = Math.min(square(fit.amplitude[0]), square(fit.amplitude[1]));
        double s0 = tones / (tones + residue.rest);
        double s1 = tones / (tones + Math.max(0, residue.rest - 1.3 * residue.restBefore));
        double tb = residue.tonesBefore / tones;
        double rb = residue.restBefore / tones;
        double line = 10 * Math.log10(1.5 * residue.strongest / weaker + 1e-9);
        double newLine = 10 * Math.log10(Math.max(1e-9, residue.newLine / weaker));
        double frac = 1.5 * residue.strongest / residue.rest;
        double tw = fit.twist();
        double c = tones / (tones + Math.max(0, all - tones - 1.2 * allBefore));
        double steady = Math.min(fit.steadiness[0], fit.steadiness[1]);
        boolean octave = line > -11
                && (Math.abs(residue.strongestHertz - 2 * rowHertz) < 35
                        || Math.abs(residue.strongestHertz - 2 * columnHertz) < 35);
        if (octave) {
            return "";
        }
        boolean fresh = afterKey || tb < 0.06;
        if (s0 > 0.9
                && c > 0.8
                && coh > 0.93
                && rip < 1.5
                && (e < 1.2 || coh > 0.96 && rip < 1.2 && line < -14 && fit.sinceOnset < 14)
                && fresh) {
            return "clean";
        }
        if (s0 > 0.97 && c > 0.8 && coh > 0.8 && steady > 0.95 && e < 1 && fresh && Math.abs(tw) < 11) {
            return "pure";
        }
        if (s0 > 0.985
                && c > 0.7
                && line < -18
                && coh > 0.85
                && steady > 0.88
                && e < 1
                && -9 < tw
                && tw < 7
                && tb < 0.5
                && fit.sinceOnset < 20) {
            return "late";
        }
        boolean quiet = tb < 0.003 && rb < 0.05;
        if (s0 > 0.85
                && c > 0.75
                && quiet
                && coh > 0.65
                && e < (coh > 0.9 && rip < 1.2 ? 1.8 : 1.3)
                && -7.5 < tw
                && tw < 7
                && line < -6) {
            return "abrupt";
        }
        if (s0 > 0.97 && c > 0.75 && quiet && coh > 0.45 && e < 2.1 && -12.5 < tw && tw < 9 && line < -13.5) {
            return "abrupt2";
        }
        double inBand = 0.088 * residue.rest;
        boolean explained = 1 - fit.coherence[0] < 0.06 + 3 * inBand / square(fit.amplitude[0])
                && 1 - fit.coherence[1] < 0.06 + 3 * inBand / square(fit.amplitude[1]);
        if (s0 > 0.28
                && s1 > 0.8
                && frac < 0.2
                && line < -3
                && tb < 0.04 + 0.4 * rb
                && coh > 0.5
                && explained
                && fit.sinceOnset < (rb > 0.9 ? 24 : 18)
                && e < 1
                && Math.abs(tw) < 10.5) {
            return "noise";
        }
        if (s0 > 0.4 && e < 0.5 && coh > 0.97 && rip < 1.3 && tb < 0.03 && Math.abs(tw) < 6) {
            return "speech";
        }
        if (fit.sinceOnset < 18
                && s0 > 0.6
                && s1 > 0.93
                && newLine < -9
                && e < 0.9
                && coh > 0.72
                && tb < 0.13
                && Math.abs(tw) < 6) {
            return "coloured";
        }
        if (s0 > 0.75 && coh > 0.96 && rip < 1.45 && tb < 0.003 && line < -9 && e < 1 && Math.abs(tw) < 5) {
            return "steady";
        }
        if (s0 > 0.85 && c > 0.8 && steady > 0.92 && tb < 0.003 && e < 1 && Math.abs(tw) < 6) {
            return "dial";
        }
        int best = fit.coherence[0] > fit.coherence[1] ? 0 : 1;
        int other = 1 - best;
        double[] toneBefore = {residue.rowBefore, residue.columnBefore};
        if (s0 > 0.4
                && fit.coherence[best] > 0.97
                && 100 * Math.abs(fit.error[best]) < 0.3
                && toneBefore[best] / square(fit.amplitude[best]) < 0.03
                && fit.coherence[other] > 0.7
                && fit.steadiness[other] > 0.92
                && 100 * Math.abs(fit.error[other]) < 0.6
                && toneBefore[other] / square(fit.amplitude[other]) < 0.4
                && Math.abs(tw) < 4.5) {
            return "half";
        }
        return "";
    }

    /** Mean square. */
    private static double power(short[] samples, int from, int to) {
        long sum = 0;
        int first = Math.max(0, from);
        for (int i = first; i < to; i++) {
            sum += samples[i] * samples[i];
        }
        return sum / (double) Math.max(1, to - first);
    }
}
