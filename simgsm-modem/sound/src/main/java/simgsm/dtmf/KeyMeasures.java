package simgsm.dtmf;

import simgsm.tone.ToneLevel;

/**
 * The measures of two tones at one moment that distinguish a key from other sound: one number per {@link Kind}. Powers are on
 * the scale of squared amplitudes.
 */
final class KeyMeasures {
    /** The measures, in the order of {@link #values}. Shares and ratios are common logarithms, so that their curves are smooth. */
    enum Kind {
        /** log10(1 - coherence) of the less steady tone over the newest 40 ms. */
        WAVER,
        /** log10(1 - coherence) of the steadier tone. */
        LEAST_WAVER,
        /** Level of the weaker tone, dBm0. */
        LEVEL,
        /** The larger frequency error, percent. */
        ERROR,
        /** Length of the tones, ms. */
        AGE,
        /**
         * log10 of the power at a tone's frequency before it began over the tone's power, the larger of the two; unknown if
         * the tones are older than 90 ms.
         */
        BEFORE,
        /** The strongest other line between 560 and 3500 Hz against the weaker tone, dB. */
        LINE,
        /** Geometric over arithmetic mean of the spectrum apart from the tones, 0.6 for noise. */
        EVENNESS,
        /** log10 of the other sound before the tones began over the other sound now; unknown as for BEFORE. */
        BACKGROUND,
        /** log10 of the strongest line's share of the other sound. */
        LINE_SHARE,
        /** The strongest line between 90 and 250 Hz, the pitch of voices, against the weaker tone, dB. */
        PITCH
    }

    /** The number of kinds, from the first, that need no spectrum. */
    static final int OF_TONES = Kind.BEFORE.ordinal();

    static final int COUNT = Kind.values().length;

    /** The onset is known to 1 ms; the time before the tones ends earlier by this. */
    private static final int ONSET_MARGIN_SAMPLES = 8;
    /** Smaller ratios are raised to this. */
    private static final double LEAST = 1e-4;
    /** By {@link Kind#ordinal}; NaN for unknown. */
    final double[] values = new double[COUNT];

    /** Number of valid kinds. */
    int known;

    private final ResidualSpectrum spectrum = new ResidualSpectrum();

    /** Measures the kinds that need no spectrum. */
    void measureTones(ToneFit fit) {
        known = OF_TONES;
        put(Kind.WAVER, log(1 - Math.min(fit.coherence[0], fit.coherence[1])));
        put(Kind.LEAST_WAVER, log(1 - Math.max(fit.coherence[0], fit.coherence[1])));
        put(Kind.LEVEL, ToneLevel.dbm0(Math.min(fit.amplitude[0], fit.amplitude[1])));
        put(Kind.ERROR, fit.errorPercent());
        put(Kind.AGE, fit.sinceOnset * GoertzelBank.HOP / DtmfGenerator.SAMPLES_PER_MILLI);
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
        double background =
                Math.max(LEAST * (row + column), spectrum.restBefore) / Math.max(LEAST * (row + column), spectrum.rest);
        put(Kind.BEFORE, fit.open ? Double.NaN : log(before));
        put(Kind.LINE, decibels(spectrum.line / weaker));
        put(Kind.EVENNESS, spectrum.evenness());
        put(Kind.BACKGROUND, fit.open ? Double.NaN : Math.log10(background));
        put(Kind.LINE_SHARE, log(spectrum.line / spectrum.rest));
        put(Kind.PITCH, decibels(spectrum.pitch / weaker));
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
