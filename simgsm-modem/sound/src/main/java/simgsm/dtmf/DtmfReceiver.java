package simgsm.dtmf;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Detects keys in 8 kHz, 16-bit mono speech (ITU-T Q.24), streaming: only digits are allocated, and the result is
 * independent of the chunk size. Owned by one thread.
 *
 * <p>A sample passes {@link ToneBank} (eight tones, every 2.5 ms), {@link ToneGate} (prominence of two of them),
 * {@link DigitTracker} (start, decision and end of a key).
 */
public final class DtmfReceiver implements KeyReceiver {
    /** Two tones with larger log odds (base e) are a key, by default. */
    public static final double LIMIT = 3.5;

    /** Samples kept before the waiting ones, for the closest look: 90 ms of tone and 28 ms before it. */
    private static final int KEPT = 1024;

    private final short[] recent = new short[KEPT + ToneBank.HOP * ToneBank.MOST_HOPS];
    private final ToneBank bank = new ToneBank();
    private final ToneGate gate = new ToneGate();
    private final DigitTracker tracker;
    private int waiting;
    private long hopsDone;

    public DtmfReceiver(DtmfListener listener) {
        this(listener, null);
    }

    /** @param candidates receives the result of each examination of strong tones; null for none */
    public DtmfReceiver(DtmfListener listener, Consumer<KeyCandidate> candidates) {
        this(listener, candidates, LIMIT);
    }

    /** @param limit log odds above which tones are a key: a higher one refuses more voices, and more disturbed keys */
    public DtmfReceiver(DtmfListener listener, Consumer<KeyCandidate> candidates, double limit) {
        this(
                listener,
                candidates,
                limit,
                (hop, key, fit, measures, samples, end) ->
                        KeyLikelihood.fitted().logOdds(measures, fit, samples, end));
    }

    /** A receiver with another judge, for the fit of the likelihood. */
    DtmfReceiver(DtmfListener listener, Consumer<KeyCandidate> candidates, double limit, DigitTracker.Judge judge) {
        tracker = new DigitTracker(bank, gate, recent, listener, candidates, limit, judge);
    }

    /** Changes the limit for the samples that follow. */
    public void setLimit(double limit) {
        tracker.setLimit(limit);
    }

    @Override
    public void accept(short[] samples, int from, int to) {
        int at = from;
        while (at < to) {
            int n = Math.min(to - at, recent.length - KEPT - waiting);
            System.arraycopy(samples, at, recent, KEPT + waiting, n);
            at += n;
            waiting += n;
            if (waiting >= ToneBank.HOP) {
                hear(waiting / ToneBank.HOP);
            }
        }
    }

    private void hear(int hops) {
        bank.accept(recent, KEPT, hops);
        tracker.accept(hopsDone, hops, KEPT);
        bank.shift(hops);
        hopsDone += hops;
        int used = hops * ToneBank.HOP;
        System.arraycopy(recent, used, recent, 0, KEPT + waiting - used);
        waiting -= used;
    }

    @Override
    public ToneLevels levels() {
        return gate.levels(bank, ToneBank.HISTORY - 1);
    }

    @Override
    public void finish() {
        tracker.finish();
    }

    @Override
    public void reset() {
        bank.clear();
        Arrays.fill(recent, (short) 0);
        tracker.reset();
        waiting = 0;
        hopsDone = 0;
    }
}
