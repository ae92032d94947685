package simgsm.dtmf;

import java.util.Arrays;

/**
 * Examines one row's and one column's tone closely, hop by hop back in time: onset, level, frequency error,
 * steadiness. Index 0 of the arrays is the row's tone, 1 the column's.
 */
final class ToneFit {
    /** Longest look back: 90 ms. */
    static final int SPAN = 36;
    /** Frequency and steadiness are measured over the newest 40 ms: some codecs need time to settle on a tone. */
    static final int LISTENED = 16;

    /** Hops with a higher likeness belong to the tone. */
    static final double HALF = 0.5;
    /** From the middle of the newest three blocks to their end, in hops. */
    static final double LAG = 1.5;

    private static final int ROW = 0;
    private static final int COLUMN = 1;
    /** Hops of the initial median of the tone's mean. */
    private static final int REFERENCE = 8;
    /** A pause that ends a digit, in half hops: an earlier tone is another one. */
    private static final double PAUSE = 4.5;
    /**
     * 9 dB louder in each tone: such hops before the newest mean that the tone is over, and the sound now is another.
     */
    private static final double FAR_LOUDER = 2.8;

    private static final int MOST_LOUDER = 2;
    /** Largest frequency error; between Q.24's limits of acceptance (1.8 %) and rejection (3 %). */
    private static final double MOST_ERROR = 0.021;
    /** A frequency error of 3 % turns the phase by less than a quarter over this lag, in hops. */
    private static final int FAR_OFF_LAG = 2;
    /** The larger limit of the newest hops, where noise disturbs the frequency. */
    private static final double[] FAR_OFF_TANGENT = Arrays.stream(GoertzelBank.HERTZ)
            .mapToDouble(hertz -> Math.tan(0.03 * FAR_OFF_LAG * radiansPerHop(hertz)))
            .toArray();

    /** Q.24 requires 8 dB plus a margin of 2 dB; no exchange accepts 15 dB. */
    static final double MOST_TWIST_DB = 12.5;
    /** Uncertainty of the onset, in hops, in noise that leaves no coherence. */
    private static final double NOISE_HOPS = 6;

    /** One turn in steps of a tone's phase from hop to hop; all tones are whole numbers of hertz. */
    private static final double[] TURN_COSINE = new double[GoertzelBank.HOPS_PER_SECOND];

    private static final double[] TURN_SINE = new double[GoertzelBank.HOPS_PER_SECOND];

    static {
        for (int i = 0; i < GoertzelBank.HOPS_PER_SECOND; i++) {
            TURN_COSINE[i] = Math.cos(radiansPerHop(i));
            TURN_SINE[i] = Math.sin(radiansPerHop(i));
        }
    }

    /** Peak, in sample units. */
    final double[] amplitude = new double[2];

    final double[] hertz = new double[2];
    /** Frequency error as a fraction. */
    final double[] error = new double[2];
    /** Share of the energy near the tone with one phase; 1 for a steady tone alone. */
    final double[] coherence = new double[2];

    final TonePair pair = new TonePair();
    /** Onset of the tones, in hops before the middle of the newest three blocks, with a fraction. */
    double sinceOnset;
    /** True if the tones lasted the whole time examined. */
    boolean open;
    /** After a look without a key: true if the tones were off their frequency rather than too short. */
    boolean offFrequency;

    private int tunedTo = -1;
    /** Hops from {@code first} up to {@code after} are measured. */
    private long first;

    private long after;
    private long newest;
    private int hops;
    private int seen;
    private int louder;
    /** Evidence of the tones, summed from the newest hop back, and its maximum. */
    private double evidence;

    private double most;
    private double perReference;
    private final double[][] re = new double[2][GoertzelBank.HISTORY];
    private final double[][] im = new double[2][GoertzelBank.HISTORY];
    /** Geometric mean of both tones' amplitudes times their gains. */
    private final double[] mean = new double[GoertzelBank.HISTORY];
    /** The mean over that of the tone's own. */
    private final double[] likeness = new double[SPAN];

    private double along;
    private double across;
    private final double[] sorted = new double[REFERENCE];

    /**
     * Examines the tones of one key.
     *
     * @param hop the newest
     * @param reach most hops to look back
     * @param rival a key directly before, possibly without a pause, or null
     * @param leastHops least length of the tones
     * @return 0 if they are long enough, still sound and are on frequency; only then the fields are valid; else hops
     *     until the next look
     */
    int measure(GoertzelBank bank, long hop, int reach, int key, TonePair rival, double leastHops) {
        follow(bank, hop, key);
        int span = Math.min(SPAN, reach);
        offFrequency = false;
        sinceOnset = 0;
        if (span < REFERENCE) {
            return 1;
        }
        reach(bank, REFERENCE - 1);
        if (isFarOff(COLUMN) || isFarOff(ROW)) {
            offFrequency = true;
            return ToneGate.EVERY;
        }
        perReference = 1 / median();
        evidence = 0;
        most = 0;
        hops = 0;
        seen = 0;
        louder = 0;
        goBack(bank, hop, Math.min(span, LISTENED), rival);
        if (sinceOnset < leastHops) {
            return (int) Math.max(1, leastHops - sinceOnset);
        }
        if (likeness[0] <= HALF || louder > MOST_LOUDER) {
            return 1;
        }
        offFrequency = !tune(ROW) || !tune(COLUMN);
        if (offFrequency) {
            return ToneGate.EVERY;
        }
        goBack(bank, hop, span, rival);
        open = hops >= span - 1;
        return 0;
    }

    /** Measures the pair up to a block. */
    private void follow(GoertzelBank bank, long hop, int key) {
        if (key != tunedTo || hop > after + REFERENCE) {
            pair.tuneTo(key);
            tunedTo = key;
            first = hop;
            after = hop;
        }
        newest = hop;
        for (; after <= hop; after++) {
            separate(bank, after);
        }
    }

    /** Measures the hops back to one that earlier looks did not. */
    private void reach(GoertzelBank bank, int i) {
        while (first > newest - i) {
            separate(bank, --first);
        }
    }

    private void separate(GoertzelBank bank, long hop) {
        int slot = (int) (hop & GoertzelBank.HISTORY - 1);
        mean[slot] = pair.measure(bank, hop);
        int second = (int) Math.floorMod(hop, (long) GoertzelBank.HOPS_PER_SECOND);
        put(ROW, slot, pair.rowReal, pair.rowImaginary, second * nominal(ROW) % GoertzelBank.HOPS_PER_SECOND);
        put(
                COLUMN,
                slot,
                pair.columnReal,
                pair.columnImaginary,
                second * nominal(COLUMN) % GoertzelBank.HOPS_PER_SECOND);
    }

    private int slot(int i) {
        return (int) (newest - i & GoertzelBank.HISTORY - 1);
    }

    /** Keeps a value less the nominal tone's rotation. */
    private void put(int tone, int slot, double x, double y, int turn) {
        re[tone][slot] = x * TURN_COSINE[turn] + y * TURN_SINE[turn];
        im[tone][slot] = y * TURN_COSINE[turn] - x * TURN_SINE[turn];
    }

    /** Median of the newest means, by insertion. */
    private double median() {
        for (int i = 0; i < REFERENCE; i++) {
            double value = mean[slot(i)];
            int at = i;
            for (; at > 0 && sorted[at - 1] > value; at--) {
                sorted[at] = sorted[at - 1];
            }
            sorted[at] = value;
        }
        return (sorted[REFERENCE / 2 - 1] + sorted[REFERENCE / 2]) / 2;
    }

    private int nominal(int tone) {
        return GoertzelBank.HERTZ[tone == ROW ? pair.row : 4 + pair.column];
    }

    /** True if the newest hops' phase is far off the frequency. Saves closer looks at voices. */
    private boolean isFarOff(int tone) {
        correlate(tone, REFERENCE, FAR_OFF_LAG, -1);
        return Math.abs(across) > along * FAR_OFF_TANGENT[tone == ROW ? pair.row : 4 + pair.column];
    }

    /** The larger error in percent; of the newest hops only if they are off frequency. */
    double errorPercent() {
        if (offFrequency) {
            for (int tone = 0; tone < 2; tone++) {
                error[tone] = turn(tone, REFERENCE, 1, 0, -1) / radiansPerHop(nominal(tone));
            }
        }
        return 100 * Math.max(Math.abs(error[ROW]), Math.abs(error[COLUMN]));
    }

    private static double radiansPerHop(double hertz) {
        return 2 * Math.PI * hertz / GoertzelBank.HOPS_PER_SECOND;
    }

    /**
     * Looks back up to a hop. The tones belong to the run of newest hops with the largest sum of evidence, which
     * bridges short interruptions if more of the tone is before them.
     */
    private void goBack(GoertzelBank bank, long hop, int until, TonePair rival) {
        for (; seen < until && evidence > most - PAUSE; seen++) {
            int i = seen;
            reach(bank, i);
            double both = mean[slot(i)];
            likeness[i] = rival != null && rival.measure(bank, hop - i) > both ? 0 : both * perReference;
            louder += likeness[i] > FAR_LOUDER ? 1 : 0;
            evidence += sounding(likeness[i]) - 0.5;
            if (evidence > most) {
                most = evidence;
                hops = i + 1;
            }
        }
        double fraction = 0.5;
        if (hops > 0 && hops < seen && likeness[hops] < likeness[hops - 1]) {
            fraction = (likeness[hops - 1] - HALF) / (likeness[hops - 1] - likeness[hops]);
        }
        sinceOnset = hops - 1 + Math.max(0, Math.min(1, fraction));
    }

    /** Evidence of the tones, 0 to 1. */
    static double sounding(double likeness) {
        return Math.max(0, Math.min(1, 2 * likeness - 0.5));
    }

    /** Frequency and steadiness of one tone. @return true if it is on frequency */
    private boolean tune(int tone) {
        int n = Math.min(hops, LISTENED);
        double turn = turn(tone, n, 2, 0, HALF);
        turn = turn(tone, n, Math.max(3, n / 2), turn, HALF);
        double deviation = turn * GoertzelBank.HOPS_PER_SECOND / (2 * Math.PI);
        hertz[tone] = nominal(tone) + deviation;
        error[tone] = deviation / nominal(tone);
        if (Math.abs(error[tone]) > MOST_ERROR) {
            return false;
        }
        cohere(tone, turn, n);
        amplitude[tone] /= TonePair.leak(deviation) * GoertzelBank.gain(hertz[tone]);
        return true;
    }

    /** Radians per hop, from the phase over a lag of the hops with more than a likeness, near an earlier estimate. */
    private double turn(int tone, int n, int lag, double near, double least) {
        correlate(tone, n, lag, least);
        double c = Math.cos(near * lag);
        double s = Math.sin(near * lag);
        return near + Math.atan2(across * c - along * s, along * c + across * s) / lag;
    }

    private void correlate(int tone, int n, int lag, double least) {
        double[] xs = re[tone];
        double[] ys = im[tone];
        along = 0;
        across = 0;
        for (int i = 0; i + lag < n; i++) {
            if (least < 0 || likeness[i] > least && likeness[i + lag] > least) {
                int to = slot(i);
                int from = slot(i + lag);
                along += xs[to] * xs[from] + ys[to] * ys[from];
                across += ys[to] * xs[from] - xs[to] * ys[from];
            }
        }
    }

    /** Level and coherence at a frequency, from the hops that belong to the tone. */
    private void cohere(int tone, double turn, int n) {
        double cosine = Math.cos(turn);
        double sine = Math.sin(turn);
        double x = 0;
        double y = 0;
        double energy = 0;
        int used = 0;
        double c = 1;
        double s = 0;
        for (int i = 0; i < n; i++) {
            if (likeness[i] > HALF) {
                double a = re[tone][slot(i)];
                double b = im[tone][slot(i)];
                x += a * c - b * s;
                y += b * c + a * s;
                energy += a * a + b * b;
                used++;
            }
            double next = c * cosine - s * sine;
            s = s * cosine + c * sine;
            c = next;
        }
        amplitude[tone] = Math.hypot(x, y) / Math.max(1, used);
        coherence[tone] = energy == 0 ? 0 : (x * x + y * y) / (used * energy);
    }

    void reset() {
        tunedTo = -1;
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
