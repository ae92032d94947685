package simgsm.dtmf;

import java.util.function.Consumer;
import simgsm.tone.ToneLevel;

/** Tracks prominent keys from hop to hop, and detects the certain ones and the end of their tones. */
final class DigitTracker {
    /**
     * Least length of a tone up to the middle of the newest three blocks, 24 ms: 3.75 ms follow it, so a key is decided
     * at 28 to 31 ms. Tones of 23 ms must be refused, those of 35 ms and more accepted.
     */
    private static final double LEAST_HOPS = 9.6;
    /** Prominent hops of a key before it is examined closely. */
    private static final int LEAST_RUN = 2;
    /** A key prominent for longer but not accepted is examined every fourth hop only. */
    private static final int OFTEN = 14;
    /**
     * Evidence of silence that ends a digit, half a hop per hop: 21 ms. Holes of 20 ms are bridged, pauses of 25 ms
     * are not.
     */
    private static final double END = 4.2;

    /** A longer gap, in hops, separates two keys: 23.5 ms. ES 201 235-3 bridges 20 ms, 25 ms are a pause. */
    private static final double MOST_GAP = 9.4;
    /** Drop of level after which the tones following a gap may be the rest of the previous key, in decibels. */
    private static final double WEAKER_DB = 5;
    /** {@link #MOST_GAP} for a copy as weak as an echo: 28.8 ms. */
    private static final double MOST_ECHO_GAP = 11.5;

    /**
     * Delays of echoes in networks without echo control, in hops: 400 ms, and 220 ms, longer than from key to key.
     */
    private static final int LATEST_ECHO = 160;

    private static final int EARLIEST_ECHO = 88;
    /** Least attenuation of an echo. */
    private static final double ECHO_DB = 15;
    /** Largest difference of an echo's frequencies, as a fraction. */
    private static final double ECHO_ERROR = 0.005;

    private final GoertzelBank bank;
    private final ToneGate gate;
    private final short[] recent;
    private final DtmfListener listener;
    /** Null without a listener. */
    private final Consumer<KeyCandidate> candidates;

    /** Log odds above which a candidate is a key. */
    private double limit;

    private final ToneFit fit = new ToneFit();
    private final KeyMeasures measures = new KeyMeasures();
    private final Judge judge;

    /** The key that stood out at the gate's last look, or -1. */
    private int gateKey = -1;

    private int runKey;
    private int run;
    private int missed;
    /** Next hop worth a look. */
    private long nextLook;

    /** Log odds of the candidate: newest window, and earlier ones. */
    private double sum;

    private double sumBefore;
    private long windowStart;
    /** The newest of the run, or null before its first look. */
    private KeyCandidate candidate;

    private DtmfDigit current;
    /** Keys decided last, in a ring. */
    private final DtmfDigit[] newest = new DtmfDigit[4];

    private int decided;
    private final TonePair sounding = new TonePair();
    /** Reciprocal of the tone's own likeness. */
    private double perLevel;

    private double silence;
    private long lastSounding;
    private DtmfDigit ended;
    /** Sound up to this hop belongs to the key that ended last; before the stream is silence. */
    private long barrier = -ToneFit.SPAN;
    /** Hop of the newest look that found the rest of a key or an echo, and its key. */
    private long repeat;

    private int repeated = -1;

    /** Log odds of one look; the receiver's are from {@link KeyMeasures#logOdds}. */
    interface Judge {
        double logOdds(long hop, int key, ToneFit fit, KeyMeasures measures, short[] samples, int end);
    }

    DigitTracker(
            GoertzelBank bank,
            ToneGate gate,
            short[] recent,
            DtmfListener listener,
            Consumer<KeyCandidate> candidates,
            double limit,
            Judge judge) {
        this.limit = limit;
        this.gate = gate;
        this.judge = judge;
        this.candidates = candidates;
        this.bank = bank;
        this.recent = recent;
        this.listener = listener;
    }

    void setLimit(double limit) {
        this.limit = limit;
    }

    /**
     * The newest hop of the bank.
     *
     * @param hop counted from the stream's start
     * @param end index after its last sample
     */
    void accept(long hop, int end) {
        if (hop % ToneGate.EVERY == 0) {
            gateKey = gate.look(bank, hop);
        }
        if (current != null) {
            follow(hop);
        } else if (gateKey < 0 && run == 0) {
            return;
        }
        if (gateKey < 0) {
            miss();
        } else {
            standsOut(gateKey);
        }
        if (run >= LEAST_RUN && isDue(hop)) {
            consider(hop, end);
        }
    }

    private void miss() {
        missed++;
        // an interruption of 10 ms may blind one look of the gate
        if (missed > ToneGate.EVERY) {
            run = 0;
            conclude();
        }
    }

    private void standsOut(int key) {
        run = key == runKey ? run + 1 : 1;
        if (run == 1) {
            conclude();
            nextLook = 0;
            sum = 0;
            sumBefore = 0;
            windowStart = Long.MIN_VALUE / 2;
        }
        runKey = key;
        missed = 0;
    }

    private boolean isDue(long hop) {
        return hop >= nextLook
                && (run <= OFTEN || hop % ToneGate.EVERY == 0)
                && (current == null || current.key().ordinal() != runKey);
    }

    private void consider(long hop, int end) {
        // in the three blocks after its last hop the key before still sounds, as loud as an echo
        int reach = (int) Math.min(ToneFit.SPAN, hop - barrier - 1);
        int wait = fit.measure(bank, hop, reach, runKey, current == null ? null : sounding, LEAST_HOPS);
        nextLook = hop + wait;
        KeyCandidate.Finding finding = finding(hop, wait);
        if (finding == null) {
            double odds = judge.logOdds(hop, runKey, fit, measures, recent, end);
            add(hop, odds);
            // log odds this low hardly reach the limit 2.5 ms later, so the next hop is left out
            nextLook = odds < -limit ? hop + 2 : hop;
            finding = sum > limit ? KeyCandidate.Finding.ACCEPTED : KeyCandidate.Finding.EVIDENCE;
        }
        if (candidates != null) {
            publish(hop, finding);
        }
        if (finding == KeyCandidate.Finding.ACCEPTED) {
            decide(hop);
        }
    }

    /** The reason why the tones are not examined closely, or null. */
    private KeyCandidate.Finding finding(long hop, int wait) {
        if (wait > 0) {
            if (fit.offFrequency) {
                return KeyCandidate.Finding.OFF_FREQUENCY;
            }
            return fit.sinceOnset < LEAST_HOPS ? KeyCandidate.Finding.TOO_SHORT : KeyCandidate.Finding.UNSTEADY;
        }
        if (isRepeat(hop)) {
            return KeyCandidate.Finding.ECHO;
        }
        if (Math.abs(fit.twist()) >= ToneFit.MOST_TWIST_DB) {
            return KeyCandidate.Finding.TWIST;
        }
        return fit.isOldEnough(LEAST_HOPS) ? null : KeyCandidate.Finding.TOO_SHORT;
    }

    private void publish(long hop, KeyCandidate.Finding finding) {
        if (candidate != null && rank(finding) < rank(candidate.finding())) {
            return; // the tones fade: what a closer look said stays
        }
        boolean isEvidence = finding == KeyCandidate.Finding.EVIDENCE;
        KeyMeasures.Kind against = isEvidence ? measures.mostAgainst() : null;
        double value = switch (finding) {
            case TOO_SHORT, UNSTEADY -> fit.sinceOnset * GoertzelBank.HOP / DtmfGenerator.SAMPLES_PER_MILLI;
            case OFF_FREQUENCY -> fit.errorPercent();
            case TWIST -> fit.twist();
            case EVIDENCE -> measures.values[against.ordinal()];
            default -> Double.NaN;
        };
        candidate = new KeyCandidate(
                DtmfKey.values()[runKey],
                Math.round(GoertzelBank.HOP * (hop + 1 - ToneFit.LAG - Math.max(fit.sinceOnset, run))),
                GoertzelBank.HOP * (hop + 1),
                finding,
                isEvidence || finding == KeyCandidate.Finding.ACCEPTED ? sum : Double.NaN,
                limit,
                isEvidence ? against.name() : "",
                value,
                false);
        candidates.accept(candidate);
    }

    /** The weight of a result: that of a full examination is higher than that of the first check. */
    private static int rank(KeyCandidate.Finding finding) {
        return switch (finding) {
            case TOO_SHORT, UNSTEADY -> 0;
            case EVIDENCE -> 2;
            case ACCEPTED -> 3;
            default -> 1;
        };
    }

    /** The tones have ended, or another key's have begun. */
    private void conclude() {
        if (candidate != null) {
            candidates.accept(candidate.over());
            candidate = null;
        }
    }

    /**
     * Adds the evidence of one look. Looks with overlapping windows are one piece of evidence, of the best one's
     * value; those at least a window apart are added, less a threshold.
     */
    private void add(long hop, double odds) {
        if (hop - windowStart >= ToneFit.LISTENED) {
            sumBefore = Math.max(0, sum - KeyMeasures.LEAST_EVIDENCE);
            windowStart = hop;
            sum = sumBefore + odds;
        } else {
            sum = Math.max(sum, sumBefore + odds);
        }
    }

    /** True for the rest of the key that ended last, for a late echo, and for tones that the looks before found to be either. */
    private boolean isRepeat(long hop) {
        double onset = hop - fit.sinceOnset;
        boolean goesOn = repeated == runKey && onset + LEAST_HOPS < repeat;
        if (!goesOn && !isRest(hop, onset) && !isEcho(onset)) {
            return false;
        }
        repeated = runKey;
        repeat = hop;
        return true;
    }

    /** True if the key that ended last continues at another level, or as an echo, after a short gap. */
    private boolean isRest(long hop, double onset) {
        if (ended == null || ended.key().ordinal() != runKey) {
            return false;
        }
        // noise shifts onsets by some hops, so tones as loud as the key before need no gap to be another key
        return drop(ended) > WEAKER_DB
                ? onset - barrier <= (isCopy(ended) ? MOST_ECHO_GAP : MOST_GAP)
                : fit.open && hop - barrier <= ToneFit.SPAN;
    }

    /**
     * True for a late echo: a key of the last 400 ms again and much weaker, after another without a pause, or later
     * than a dialler's next key.
     */
    private boolean isEcho(double onset) {
        for (int i = 0; i < Math.min(newest.length, decided); i++) {
            DtmfDigit each = newest[i];
            double later = onset - each.startedAtSample() / (double) GoertzelBank.HOP;
            if (each.key().ordinal() == runKey
                    && later < LATEST_ECHO
                    && (later > EARLIEST_ECHO || onset - barrier < GoertzelBank.HOPS_PER_SECOND / 100)
                    && isCopy(each)) {
                return true;
            }
        }
        return false;
    }

    private boolean isCopy(DtmfDigit digit) {
        return drop(digit) > ECHO_DB
                && Math.abs(digit.rowError() - fit.error[0]) < ECHO_ERROR
                && Math.abs(digit.columnError() - fit.error[1]) < ECHO_ERROR;
    }

    /** How much weaker than a key the tones are, in decibels, mean of both. */
    private double drop(DtmfDigit digit) {
        return (digit.rowDbm0()
                        + digit.columnDbm0()
                        - ToneLevel.dbm0(fit.amplitude[0])
                        - ToneLevel.dbm0(fit.amplitude[1]))
                / 2;
    }

    private void decide(long hop) {
        if (current != null) {
            lastSounding = Math.min(hop, Math.round(hop - fit.sinceOnset));
            end();
        }
        long now = GoertzelBank.HOP * (hop + 1);
        long start = Math.round(GoertzelBank.HOP * (hop + 1 - ToneFit.LAG - fit.sinceOnset));
        current = new DtmfDigit(
                DtmfKey.at(fit.pair.row, fit.pair.column),
                now,
                start,
                now - start,
                ToneLevel.dbm0(fit.amplitude[0]),
                ToneLevel.dbm0(fit.amplitude[1]),
                fit.error[0],
                fit.error[1]);
        sounding.tuneTo(current.key().ordinal());
        double both =
                fit.amplitude[0] * fit.amplitude[1] * GoertzelBank.gain(fit.hertz[0]) * GoertzelBank.gain(fit.hertz[1]);
        perLevel = 1 / Math.sqrt(both);
        silence = 0;
        lastSounding = hop;
        newest[decided++ % newest.length] = current;
        listener.keyDecided(current);
    }

    /** Checks if the decided key still sounds. */
    private void follow(long hop) {
        double likeness = sounding.measure(bank, hop) * perLevel;
        silence = Math.max(0, silence + 0.5 - ToneFit.sounding(likeness));
        if (likeness > ToneFit.HALF) {
            lastSounding = hop;
        }
        if (silence >= END) {
            end();
        }
    }

    private void end() {
        DtmfDigit digit = current;
        current = null;
        ended = digit;
        barrier = lastSounding;
        // a tone that sounds in the newest block lasts to its end
        double lag = lastSounding + 1 == bank.hops() ? 0 : ToneFit.LAG;
        long duration = Math.max(0, Math.round(GoertzelBank.HOP * (lastSounding + 1 - lag)) - digit.startedAtSample());
        listener.keyEnded(digit.withDuration(duration));
    }

    void finish() {
        conclude();
        if (current != null) {
            end();
        }
    }

    void reset() {
        fit.reset();
        current = null;
        ended = null;
        decided = 0;
        gateKey = -1;
        run = 0;
        candidate = null;
        missed = 0;
        barrier = -ToneFit.SPAN;
        repeated = -1;
        nextLook = 0;
    }
}
