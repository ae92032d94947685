package simgsm.dtmf;

/**
 * Examines one row's and one column's tone closely, hop by hop back in time: onset, level, frequency error,
 * steadiness. Index 0 of the arrays is the row's tone, 1 the column's.
 */
final class ToneFit {
    /** Longest look back: 90 ms. */
    static final int SPAN = 36;

    private static final int ROW = 0;
    private static final int COLUMN = 1;
    /** Frequency and steadiness are measured over the newest 40 ms: some codecs need time to settle on a tone. */
    static final int LISTENED = 16;
    /** Hops of the initial median of the tone's power. */
    private static final int REFERENCE = 8;
    /** A pause that ends a digit, in half hops: an earlier tone is another one. */
    private static final double PAUSE = 4.5;
    /** The likeness of a quarter, half and three quarters of the amplitude. */
    private static final double QUARTER = 1 / 256.0;

    static final double HALF = 1 / 16.0;
    private static final double THREE_QUARTERS = 81 / 256.0;
    /**
     * 9 dB louder in each tone: such hops before the newest mean that the tone is over, and the sound now is another.
     */
    private static final double FAR_LOUDER = 64;

    private static final int MOST_LOUDER = 2;
    /** Hops until tones off their frequency are examined again: 5 ms. */
    private static final int OFF_FREQUENCY_WAIT = 2;
    /** Largest frequency error; between Q.24's limits of acceptance (1.8 %) and rejection (3 %). */
    private static final double MOST_ERROR = 0.021;
    /** Q.24 requires 8 dB plus a margin of 2 dB; no exchange accepts 15 dB. */
    static final double MOST_TWIST_DB = 12.5;
    /** Uncertainty of the onset, in hops, in noise that leaves no coherence. */
    private static final double NOISE_HOPS = 6;
    /**
     * Tangents of the phase turn by 4 % over a lag of one hop for the highest column, of two hops for the highest
     * row.
     */
    private static final double[] FAR_OFF_TANGENTS = {
        0,
        Math.tan(2 * Math.PI * 0.04 * 1633 / ToneBank.HOPS_PER_SECOND),
        Math.tan(4 * Math.PI * 0.04 * 941 / ToneBank.HOPS_PER_SECOND)
    };

    /** One turn in steps of a tone's phase from hop to hop; all tones are whole numbers of hertz. */
    private static final double[] TURN_COSINE = new double[ToneBank.HOPS_PER_SECOND];

    private static final double[] TURN_SINE = new double[ToneBank.HOPS_PER_SECOND];

    static {
        for (int i = 0; i < ToneBank.HOPS_PER_SECOND; i++) {
            TURN_COSINE[i] = Math.cos(2 * Math.PI * i / ToneBank.HOPS_PER_SECOND);
            TURN_SINE[i] = Math.sin(2 * Math.PI * i / ToneBank.HOPS_PER_SECOND);
        }
    }

    /** Peak, in sample units. */
    final double[] amplitude = new double[2];

    final double[] hertz = new double[2];
    /** Frequency error as a fraction. */
    final double[] error = new double[2];
    /** Share of the energy near the tone with one phase; 1 for a steady tone alone. */
    final double[] coherence = new double[2];

    int row;
    int column;
    /** Onset of the tones, in hops before the newest, with a fraction. */
    double sinceOnset;
    /** True if the tones lasted the whole time examined. */
    boolean open;
    /** After a look without a key: true if the tones were off their frequency rather than too short. */
    boolean offFrequency;

    private int hops;
    private int seen;
    private int louder;
    /** Evidence of the tones, summed from the newest hop back, and its maximum. */
    private double evidence;

    private double most;
    private double perReference;
    private final double[][] re = new double[2][SPAN];
    private final double[][] im = new double[2][SPAN];
    private final double[][] power = new double[2][SPAN];
    /** Product of both tones' powers over that of the tone's own: the fourth power of their mean amplitude's ratio. */
    private final double[] likeness = new double[SPAN];

    private final double[] smoothRe = new double[SPAN];
    private final double[] smoothIm = new double[SPAN];
    private final double[] sorted = new double[REFERENCE];

    private double leak;
    private double scale;

    /**
     * Examines the tones of one key.
     *
     * @param newest index of the newest hop in the bank
     * @param hopNumber the newest hop counted from the stream's start
     * @param reach most hops to look back
     * @param rival a key directly before, possibly without a pause, or null
     * @param leastHops least length of the tones
     * @return 0 if they are long enough, still sound and are on frequency; only then the fields are valid; else hops
     *     until the next look
     */
    int measure(ToneBank bank, int newest, long hopNumber, int reach, int key, DtmfKey rival, double leastHops) {
        row = key / 4;
        column = key % 4;
        leak = ToneBank.leakBetween(row, 4 + column);
        scale = 1 / (1 - leak * leak);
        int span = Math.min(SPAN, reach);
        offFrequency = false;
        sinceOnset = 0;
        if (span < REFERENCE) {
            return 1;
        }
        for (int i = 0; i < REFERENCE; i++) {
            separate(bank, newest - i, i);
        }
        if (isFarOff(ROW, 2, (int) ToneBank.HERTZ[row]) || isFarOff(COLUMN, 1, (int) ToneBank.HERTZ[4 + column])) {
            offFrequency = true;
            return 1;
        }
        beginWith(reference());
        goBack(bank, newest, Math.min(span, LISTENED), rival);
        if (sinceOnset < leastHops) {
            return (int) Math.max(1, leastHops - sinceOnset);
        }
        if (likeness[0] <= HALF || louder > MOST_LOUDER) {
            return 1;
        }
        boolean tuned = tune(ROW, (int) ToneBank.HERTZ[row], hopNumber)
                && tune(COLUMN, (int) ToneBank.HERTZ[4 + column], hopNumber);
        offFrequency = !tuned;
        if (tuned) {
            goBack(bank, newest, span, rival);
            open = hops >= span - 1;
        }
        return tuned ? 0 : OFF_FREQUENCY_WAIT;
    }

    /** Median of the product of both tones' powers, by insertion. */
    private double reference() {
        for (int i = 0; i < REFERENCE; i++) {
            double value = power[ROW][i] * power[COLUMN][i];
            int at = i;
            for (; at > 0 && sorted[at - 1] > value; at--) {
                sorted[at] = sorted[at - 1];
            }
            sorted[at] = value;
        }
        return (sorted[REFERENCE / 2 - 1] + sorted[REFERENCE / 2]) / 2;
    }

    /** True if the newest hops' phase over a lag is 4 % or more off the frequency. Saves closer looks at voices. */
    private boolean isFarOff(int tone, int lag, int nominalHertz) {
        double[] x = re[tone];
        double[] y = im[tone];
        double along = 0;
        double across = 0;
        for (int i = 0; i + lag < REFERENCE; i++) {
            along += x[i] * x[i + lag] + y[i] * y[i + lag];
            across += y[i] * x[i + lag] - x[i] * y[i + lag];
        }
        int turn = lag * nominalHertz % ToneBank.HOPS_PER_SECOND;
        double near = along * TURN_COSINE[turn] + across * TURN_SINE[turn];
        double off = across * TURN_COSINE[turn] - along * TURN_SINE[turn];
        error[tone] = Math.atan2(off, near) * ToneBank.HOPS_PER_SECOND / (2 * Math.PI * lag * nominalHertz);
        return Math.abs(off) > near * FAR_OFF_TANGENTS[lag];
    }

    /** Subtracts the leakage of the other tone from each. */
    private void separate(ToneBank bank, int at, int i) {
        double rowRe = bank.real[row][at];
        double rowIm = bank.imaginary[row][at];
        double columnRe = bank.real[4 + column][at];
        double columnIm = bank.imaginary[4 + column][at];
        put(ROW, i, scale * (rowRe - leak * columnRe), scale * (rowIm - leak * columnIm));
        put(COLUMN, i, scale * (columnRe - leak * rowRe), scale * (columnIm - leak * rowIm));
    }

    private void put(int tone, int i, double x, double y) {
        re[tone][i] = x;
        im[tone][i] = y;
        power[tone][i] = x * x + y * y;
    }

    private void beginWith(double reference) {
        perReference = 1 / reference;
        evidence = 0;
        most = 0;
        hops = 0;
        seen = 0;
        louder = 0;
    }

    /**
     * Looks back up to a hop. The tones belong to the run of newest hops with the largest sum of evidence, which
     * bridges short interruptions if more of the tone is before them.
     */
    private void goBack(ToneBank bank, int newest, int until, DtmfKey rival) {
        for (; seen < until && evidence > most - PAUSE; seen++) {
            int i = seen;
            if (i >= REFERENCE) {
                separate(bank, newest - i, i);
            }
            likeness[i] = isRivals(bank, newest - i, rival) ? 0 : power[ROW][i] * power[COLUMN][i] * perReference;
            louder += likeness[i] > FAR_LOUDER ? 1 : 0;
            evidence += sounding(likeness[i]) - 0.5;
            if (evidence > most) {
                most = evidence;
                hops = i + 1;
            }
        }
        double fraction = 0.5;
        if (hops > 0 && hops < seen && likeness[hops] < likeness[hops - 1]) {
            double inside = amplitudeRatio(likeness[hops - 1]);
            fraction = (inside - 0.5) / (inside - amplitudeRatio(likeness[hops]));
        }
        sinceOnset = hops - 1 + Math.max(0, Math.min(1, fraction));
    }

    private static double amplitudeRatio(double likeness) {
        return Math.sqrt(Math.sqrt(likeness));
    }

    /** Evidence of the tones, 0 to 1: twice the amplitude's ratio less a half. */
    static double sounding(double likeness) {
        if (likeness >= THREE_QUARTERS) {
            return 1;
        }
        return likeness <= QUARTER ? 0 : 2 * amplitudeRatio(likeness) - 0.5;
    }

    /** A sounding key leaks into the tones next to its own, which must not be taken for this key's. */
    private boolean isRivals(ToneBank bank, int at, DtmfKey rival) {
        return rival != null
                && bank.power(rival.row(), at) * bank.power(4 + rival.column(), at)
                        > bank.power(row, at) * bank.power(4 + column, at);
    }

    /** Frequency and steadiness of one tone. @return true if it is on frequency */
    private boolean tune(int tone, int nominalHertz, long hopNumber) {
        int n = Math.min(hops, LISTENED);
        amplitude[tone] = Math.sqrt(intoStep(tone, nominalHertz, hopNumber, n));
        smooth(tone, n);
        double turn = turn(n, 2, 0);
        turn = turn(n, Math.max(3, n / 2), turn);
        double deviation = turn * ToneBank.HOPS_PER_SECOND / (2 * Math.PI);
        hertz[tone] = nominalHertz + deviation;
        error[tone] = deviation / nominalHertz;
        if (Math.abs(error[tone]) > MOST_ERROR) {
            return false;
        }
        amplitude[tone] /= ToneBank.leak(deviation);
        coherence[tone] = coherence(re[tone], im[tone], turn, n);
        return true;
    }

    /** Removes the nominal tone's rotation. @return mean square amplitude */
    private double intoStep(int tone, int nominalHertz, long hopNumber, int n) {
        double energy = 0;
        int used = 0;
        int turn = (int) (hopNumber * nominalHertz % ToneBank.HOPS_PER_SECOND);
        int step = nominalHertz % ToneBank.HOPS_PER_SECOND;
        for (int i = 0; i < n; i++) {
            double c = TURN_COSINE[turn];
            double s = TURN_SINE[turn];
            double x = re[tone][i] * c + im[tone][i] * s;
            im[tone][i] = im[tone][i] * c - re[tone][i] * s;
            re[tone][i] = x;
            if (likeness[i] > HALF) {
                energy += power[tone][i];
                used++;
            }
            turn -= step;
            turn += turn < 0 ? ToneBank.HOPS_PER_SECOND : 0;
        }
        return energy / used;
    }

    private void smooth(int tone, int n) {
        double[] x = re[tone];
        double[] y = im[tone];
        for (int i = 1; i < n - 1; i++) {
            smoothRe[i] = 0.25 * (x[i - 1] + 2 * x[i] + x[i + 1]);
            smoothIm[i] = 0.25 * (y[i - 1] + 2 * y[i] + y[i + 1]);
        }
    }

    /** Radians per hop, from the smooth hops' phase over a lag, near an earlier estimate. */
    private double turn(int n, int lag, double near) {
        double x = 0;
        double y = 0;
        for (int i = 1; i + lag < n - 1; i++) {
            if (likeness[i] > HALF && likeness[i + lag] > HALF) {
                x += smoothRe[i] * smoothRe[i + lag] + smoothIm[i] * smoothIm[i + lag];
                y += smoothIm[i] * smoothRe[i + lag] - smoothRe[i] * smoothIm[i + lag];
            }
        }
        double c = Math.cos(near * lag);
        double s = Math.sin(near * lag);
        return near + Math.atan2(y * c - x * s, x * c + y * s) / lag;
    }

    private double coherence(double[] xs, double[] ys, double turn, int n) {
        double stepCosine = Math.cos(turn);
        double stepSine = Math.sin(turn);
        double c = 1;
        double s = 0;
        double x = 0;
        double y = 0;
        double energy = 0;
        int used = 0;
        for (int i = 0; i < n; i++) {
            if (likeness[i] > HALF) {
                x += xs[i] * c - ys[i] * s;
                y += ys[i] * c + xs[i] * s;
                energy += xs[i] * xs[i] + ys[i] * ys[i];
                used++;
            }
            double next = c * stepCosine - s * stepSine;
            s = s * stepCosine + c * stepSine;
            c = next;
        }
        return energy == 0 ? 0 : (x * x + y * y) / (used * energy);
    }

    /** In decibels, high group over low. */
    double twist() {
        return 20 * Math.log10(amplitude[COLUMN] / amplitude[ROW]);
    }

    /** True if the tones have lasted this number of hops, or more where noise hides their onset. */
    boolean isOldEnough(double leastHops) {
        return sinceOnset >= leastHops + NOISE_HOPS * (1 - Math.min(coherence[ROW], coherence[COLUMN]));
    }
}
