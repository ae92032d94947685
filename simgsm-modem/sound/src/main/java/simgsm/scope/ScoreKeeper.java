package simgsm.scope;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import simgsm.dtmf.DtmfKey;

/** Compares two receivers' decisions; decisions on one key are within 100 ms of each other. */
final class ScoreKeeper {
    private static final long PATIENCE_SAMPLES = 800;

    private record Decision(DtmfKey key, long sample) {}

    private final Deque<Decision> genuine = new ArrayDeque<>();
    private final Deque<Decision> tried = new ArrayDeque<>();
    private ToneScore score = ToneScore.NONE;

    /** A key of the undisturbed sound. */
    void truth(DtmfKey key, long sample) {
        decided(genuine, tried, new Decision(key, sample));
    }

    /** A key of the disturbed sound. */
    void attempt(DtmfKey key, long sample) {
        decided(tried, genuine, new Decision(key, sample));
    }

    private void decided(Deque<Decision> own, Deque<Decision> other, Decision decision) {
        for (Iterator<Decision> each = other.iterator(); each.hasNext(); ) {
            if (each.next().key() == decision.key()) {
                each.remove();
                score = new ToneScore(score.heard() + 1, score.missed(), score.invented());
                return;
            }
        }
        own.add(decision);
    }

    /** Counts decisions without a counterpart in time. */
    void timePassed(long sample) {
        while (isOverdue(genuine.peek(), sample)) {
            genuine.remove();
            score = new ToneScore(score.heard(), score.missed() + 1, score.invented());
        }
        while (isOverdue(tried.peek(), sample)) {
            tried.remove();
            score = new ToneScore(score.heard(), score.missed(), score.invented() + 1);
        }
    }

    private static boolean isOverdue(Decision decision, long sample) {
        return decision != null && sample - decision.sample() > PATIENCE_SAMPLES;
    }

    ToneScore score() {
        return score;
    }

    void clear() {
        genuine.clear();
        tried.clear();
        score = ToneScore.NONE;
    }
}
