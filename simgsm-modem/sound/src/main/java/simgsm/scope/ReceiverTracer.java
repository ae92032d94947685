package simgsm.scope;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfListener;
import simgsm.dtmf.KeyCandidate;
import simgsm.dtmf.KeyReceiver;
import simgsm.dtmf.ToneLevels;

/** Runs one receiver for a tone scope and keeps its newest findings. Owned by one thread. */
final class ReceiverTracer implements DtmfListener {
    private final KeyReceiver receiver;
    private final ScoreKeeper scores = new ScoreKeeper();
    private final LongSupplier clockSamples;
    private final Deque<KeyCandidate> candidates = new ArrayDeque<>();
    private DtmfDigit digit;
    private boolean sounding;
    private boolean resting = true;

    /**
     * @param opened makes the receiver from a listener for keys and one for candidates
     * @param clockSamples samples of the undisturbed sound so far
     */
    ReceiverTracer(BiFunction<DtmfListener, Consumer<KeyCandidate>, KeyReceiver> opened, LongSupplier clockSamples) {
        this.clockSamples = clockSamples;
        receiver = opened.apply(this, this::add);
    }

    void accept(short[] samples) {
        resting = false;
        receiver.accept(samples);
    }

    /** Ends the tone; no sound follows for now. */
    void rest() {
        receiver.finish();
        sounding = false;
        resting = true;
    }

    void reset() {
        receiver.reset();
        scores.clear();
        candidates.clear();
        digit = null;
        sounding = false;
        resting = true;
    }

    ScoreKeeper scores() {
        return scores;
    }

    boolean isSounding() {
        return sounding;
    }

    ReceiverTrace newest(boolean isExperiment) {
        return new ReceiverTrace(
                resting ? ToneLevels.SILENCE : receiver.levels(),
                Optional.ofNullable(digit),
                sounding,
                List.copyOf(candidates),
                isExperiment ? scores.score() : ToneScore.NONE);
    }

    private void add(KeyCandidate candidate) {
        if (!candidates.isEmpty() && !candidates.getLast().isOver()) {
            candidates.removeLast();
        }
        candidates.addLast(candidate);
        if (candidates.size() > ReceiverTrace.MOST_CANDIDATES) {
            candidates.removeFirst();
        }
    }

    @Override
    public void keyDecided(DtmfDigit decided) {
        digit = decided;
        sounding = true;
        scores.attempt(decided.key(), clockSamples.getAsLong());
    }

    @Override
    public void keyEnded(DtmfDigit ended) {
        digit = ended;
        sounding = false;
    }
}
