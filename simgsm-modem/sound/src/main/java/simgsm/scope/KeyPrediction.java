package simgsm.scope;

import java.util.Optional;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.ToneLevels;

/**
 * A student reads keys off the picture: each detected key is hidden, and the picture of its tones at their strongest
 * held, until a guess is made. Keys received meanwhile are skipped. Not thread-safe.
 */
public final class KeyPrediction {
    /** The stages of a question. */
    public enum Stage {
        /** Off: keys are shown. */
        OFF,
        /** No tone since the last guess. */
        WAITING,
        /** A tone is shown without its key. */
        ASKING,
        /** The last guess was right; the key is shown. */
        RIGHT,
        /** The last guess was wrong; the key is shown. */
        WRONG
    }

    private static final int ROWS = 4;

    private Stage stage = Stage.OFF;
    private ToneTrace newest = ToneTrace.EMPTY;
    private ToneTrace held = ToneTrace.EMPTY;
    private Optional<DtmfDigit> known = Optional.empty();
    private DtmfKey answer;
    private int right;
    private int asked;

    public KeyPrediction() {}

    /** Starts or ends questions. The previous key is not asked for. */
    public void set(boolean on) {
        stage = on ? Stage.WAITING : Stage.OFF;
        known = digit(newest);
        right = 0;
        asked = 0;
    }

    public void hear(ToneTrace trace) {
        newest = trace;
        Optional<DtmfDigit> digit = digit(trace);
        boolean isNew = digit.isPresent() && !isSame(digit, known);
        if (stage == Stage.ASKING) {
            if (isSame(digit, digit(held)) && strength(trace) >= strength(held)) {
                held = trace;
            }
        } else if (stage != Stage.OFF && isNew) {
            ask(trace, digit.get().key());
        }
        if (digit.isPresent()) {
            known = digit;
        }
    }

    /** Asks for the key of this picture, detected or not. */
    public void ask(ToneTrace trace, DtmfKey key) {
        stage = Stage.ASKING;
        held = trace;
        answer = key;
    }

    /** Level of the key's weaker tone in dBm0, low at the tone's start and end. */
    private double strength(ToneTrace trace) {
        ToneLevels levels = trace.modem().levels();
        return Math.min(levels.dbm0(answer.row()), levels.dbm0(ROWS + answer.column()));
    }

    private static Optional<DtmfDigit> digit(ToneTrace trace) {
        return trace.modem().digit();
    }

    /** Equal except for the duration, which grows while the tone sounds. */
    private static boolean isSame(Optional<DtmfDigit> one, Optional<DtmfDigit> other) {
        return one.isPresent()
                && other.isPresent()
                && one.get().key() == other.get().key()
                && one.get().decidedAtSample() == other.get().decidedAtSample();
    }

    /** Guesses the key asked for; no effect without a question. */
    public void guess(DtmfKey key) {
        if (stage == Stage.ASKING) {
            asked++;
            boolean isRight = answer == key;
            right += isRight ? 1 : 0;
            stage = isRight ? Stage.RIGHT : Stage.WRONG;
        }
    }

    public Stage stage() {
        return stage;
    }

    /** True if keys are hidden now. */
    public boolean isHiding() {
        return stage == Stage.WAITING || stage == Stage.ASKING;
    }

    /** The picture of the current or last question; empty if there is none. */
    public Optional<ToneTrace> held() {
        return stage == Stage.OFF || stage == Stage.WAITING ? Optional.empty() : Optional.of(held);
    }

    /** The key played; empty while no picture is held. */
    public Optional<DtmfKey> answer() {
        return held().map(picture -> answer);
    }

    /** Right guesses since the start. */
    public int right() {
        return right;
    }

    /** Guesses since the start. */
    public int asked() {
        return asked;
    }
}
