package simgsm.dtmf;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Detects keys in 8 kHz, 16-bit mono speech (ITU-T Q.24), streaming: only digits are allocated, and the result is
 * independent of the chunk size. Owned by one thread.
 *
 * <p>A sample passes {@link GoertzelBank} (eight tones, every 2.5 ms), {@link ToneGate} (prominence of two of them),
 * {@link DigitTracker} (start, decision and end of a key).
 */
public final class DtmfReceiver implements KeyReceiver {
    /** Two tones with larger log odds (base e) are a key, by default. */
    public static final double LIMIT = 3.5;

    /** Samples kept before the waiting ones, for the closest look: 90 ms of tone and 28 ms before it. */
    private static final int KEPT = 1024;

    private static final int ROOM = 4 * KEPT;

    private final short[] recent = new short[ROOM];
    private final GoertzelBank bank = new GoertzelBank();
    private final ToneGate gate = new ToneGate();
    private final DigitTracker tracker;
    /** Samples up to here were heard; those up to {@code filled} wait for a whole hop. */
    private int heard = KEPT;

    private int filled = KEPT;

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
                (hop, key, fit, measures, samples, end) -> measures.logOdds(fit, samples, end));
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
        for (int at = from; at < to; ) {
            if (filled == ROOM) {
                System.arraycopy(recent, heard - KEPT, recent, 0, filled - heard + KEPT);
                filled += KEPT - heard;
                heard = KEPT;
            }
            int n = Math.min(to - at, ROOM - filled);
            System.arraycopy(samples, at, recent, filled, n);
            at += n;
            filled += n;
            for (; heard + GoertzelBank.HOP <= filled; heard += GoertzelBank.HOP) {
                bank.accept(recent, heard);
                tracker.accept(bank.hops() - 1, heard + GoertzelBank.HOP);
            }
        }
    }

    @Override
    public ToneLevels levels() {
        return gate.levels(bank);
    }

    @Override
    public void finish() {
        tracker.finish();
    }

    @Override
    public void reset() {
        bank.reset();
        Arrays.fill(recent, (short) 0);
        tracker.reset();
        heard = KEPT;
        filled = KEPT;
    }
}
