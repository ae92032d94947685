package simgsm.dtmf;

import java.util.Arrays;
import java.util.Comparator;
import simgsm.tone.ToneLevel;

/**
 * The measures of two tones at one moment that distinguish a key from other sound, and the log odds that they are a key's: those
 * of the best key, less a penalty for each {@link Kind}. Powers are on the scale of squared amplitudes.
 */
final class KeyMeasures {
    /**
     * The measures, in the order of {@link #values}, with their curves: pairs of a value and its addend, between which and
     * beyond which the addend is linear and constant. {@code LikelihoodFit}, a test program, fitted the addends to labelled
     * recordings; {@link #WANDER}'s was chosen afterwards. Shares and ratios are common logarithms.
     */
    enum Kind {
        /** log10(1 - coherence) of the steadier tone over the newest 40 ms. */
        WAVER(-3.5, 0, -2.2, -1.88, -0.3, -13.66),
        /** Level of the weaker tone, dBm0. */
        LEVEL(-36, -7.19, -24, -2.21, -12, 0),
        /** The larger frequency error, percent. */
        ERROR(0.2, 0, 2.1, -5.5),
        /**
         * log10 of the power at a tone's frequency before it began over the tone's power, the larger of the two; 0 if the tones
         * are older than 90 ms.
         */
        BEFORE(-3.5, 0, 0, -9.97),
        /** The strongest other line between 560 and 3500 Hz against the weaker tone, dB. */
        LINE(-15, 0, -4, -1.97, 4, -5.69),
        /** Geometric over arithmetic mean of the spectrum apart from the tones, 0.6 for noise. */
        EVENNESS(0.04, -9.76, 0.12, -7.67, 0.25, -4.11, 0.4, -6.6, 0.6, 0),
        /** log10 of the other sound before the tones began over the other sound now; 0 as for BEFORE. */
        BACKGROUND(-1.8, -5.5, 0.1, 0, 1, -1.92),
        /** log10 of the strongest line's share of the other sound. */
        LINE_SHARE(-1.1, -0.79, -0.6, -5.37, -0.15, 0),
        /** The strongest line between 90 and 250 Hz, the pitch of voices, against the weaker tone, dB. */
        PITCH(-10, 0, 12, -6.16),
        /** log10 of 1 - coherence over {@link #LINE}'s ratio: tones that waver without other sound slide. */
        WANDER(1.6, 0, 3.4, -7);

        final double[] curve;

        Kind(double... curve) {
            this.curve = curve;
        }

        /** The addend of a value. */
        double addend(double value) {
            int i = 0;
            while (i < curve.length && curve[i] < value) {
                i += 2;
            }
            if (i == 0 || i == curve.length) {
                return curve[i == 0 ? 1 : i - 1];
            }
            double share = (value - curve[i - 2]) / (curve[i] - curve[i - 2]);
            return curve[i - 1] + share * (curve[i + 1] - curve[i - 1]);
        }
    }

    /** Subtracted from the log odds of an earlier window before they are added. */
    static final double LEAST_EVIDENCE = 1.5;

    private static final double BIAS = 25.88;
    private static final Kind[] KINDS = Kind.values();

    /** The number of kinds, from the first, that need no spectrum. */
    static final int OF_TONES = Kind.BEFORE.ordinal();

    static final int COUNT = KINDS.length;

    /** The onset is known to 1 ms; the time before the tones ends earlier by this. */
    private static final int ONSET_MARGIN_SAMPLES = 8;
    /** Smaller ratios are raised to this. */
    private static final double LEAST = 1e-4;
    /** By {@link Kind#ordinal}. */
    final double[] values = new double[COUNT];

    /** Number of valid kinds. */
    int known;

    private final ResidualSpectrum spectrum = new ResidualSpectrum();

    /** The log odds; any value up to 0 if they cannot be larger for any spectrum. */
    double logOdds(ToneFit fit, short[] samples, int end) {
        measureTones(fit);
        double sum = BIAS;
        for (int kind = 0; kind < OF_TONES; kind++) {
            sum += addend(KINDS[kind]);
        }
        if (sum > 0) {
            measureSpectrum(fit, samples, end);
            for (int kind = OF_TONES; kind < COUNT; kind++) {
                sum += addend(KINDS[kind]);
            }
        }
        return sum;
    }

    private double addend(Kind kind) {
        return kind.addend(values[kind.ordinal()]);
    }

    /** The measure with the strongest evidence against a key. */
    Kind mostAgainst() {
        return Arrays.stream(KINDS, 0, known)
                .min(Comparator.comparingDouble(this::addend))
                .orElseThrow();
    }

    /** Measures the kinds that need no spectrum. */
    void measureTones(ToneFit fit) {
        known = OF_TONES;
        put(Kind.WAVER, log(1 - Math.max(fit.coherence[0], fit.coherence[1])));
        put(Kind.LEVEL, ToneLevel.dbm0(Math.min(fit.amplitude[0], fit.amplitude[1])));
        put(Kind.ERROR, fit.errorPercent());
    }

    /**
     * Measures the other kinds.
     *
     * @param end index after the newest of {@code samples}
     */
    void measureSpectrum(ToneFit fit, short[] samples, int end) {
        known = COUNT;
        double row = square(fit.amplitude[0]);
        double column = square(fit.amplitude[1]);
        double weaker = Math.min(row, column);
        int began = (int) (end - GoertzelBank.HOP * (fit.sinceOnset + ToneFit.LAG));
        spectrum.measure(samples, end, began - ONSET_MARGIN_SAMPLES, fit.hertz[0], fit.hertz[1]);
        double before = Math.max(spectrum.rowBefore / row, spectrum.columnBefore / column);
        double least = LEAST * (row + column);
        double background = Math.max(least, spectrum.restBefore) / Math.max(least, spectrum.rest);
        put(Kind.BEFORE, fit.open ? 0 : log(before));
        put(Kind.LINE, decibels(spectrum.line / weaker));
        put(Kind.EVENNESS, spectrum.evenness());
        put(Kind.BACKGROUND, fit.open ? 0 : Math.log10(background));
        put(Kind.LINE_SHARE, log(spectrum.line / spectrum.rest));
        put(Kind.PITCH, decibels(spectrum.pitch / weaker));
        put(Kind.WANDER, values[Kind.WAVER.ordinal()] - log(spectrum.line / weaker));
    }

    private void put(Kind kind, double value) {
        values[kind.ordinal()] = value;
    }

    private static double square(double x) {
        return x * x;
    }

    private static double log(double ratio) {
        return Math.log10(Math.max(LEAST, ratio));
    }

    private static double decibels(double ratio) {
        return 10 * Math.log10(Math.max(1e-12, ratio));
    }
}
