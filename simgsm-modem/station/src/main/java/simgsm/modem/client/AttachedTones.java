package simgsm.modem.client;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import simgsm.dtmf.DtmfKey;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** The reply tones of a call, one at a time: in its sound, or without one by {@code +VTS}. */
final class AttachedTones {
    /** A tone of 200 ms, and 70 ms of pause. */
    static final long TONE_NANOS = TimeUnit.MILLISECONDS.toNanos(270);

    private final CommandDialogue dialogue;
    private final Timers timers;
    private final AttachedSound sound;
    private final BiConsumer<DtmfKey, Boolean> ended;
    private final Deque<DtmfKey> waiting = new ArrayDeque<>();
    private DtmfKey underWay;
    private Timer timer;

    /** @param ended receives each tone once, with true if it was sent */
    AttachedTones(CommandDialogue dialogue, Timers timers, AttachedSound sound, BiConsumer<DtmfKey, Boolean> ended) {
        this.dialogue = dialogue;
        this.timers = timers;
        this.sound = sound;
        this.ended = ended;
    }

    void queue(DtmfKey key) {
        waiting.add(key);
        if (underWay == null) {
            next();
        }
    }

    void drop() {
        timers.cancel(timer);
        waiting.clear();
        underWay = null;
    }

    /** Begins the tone again that the lost sound has cut. */
    void soundLost() {
        if (underWay != null) {
            begin(underWay);
        }
    }

    private void next() {
        underWay = waiting.poll();
        if (underWay != null) {
            begin(underWay);
        }
    }

    private void begin(DtmfKey key) {
        if (sound.isLive()) {
            sound.play(key);
            return;
        }
        long began = timers.nowNanos();
        ModemCommand command = ModemCommand.of("AT+VTS=" + key.symbol()).within(AttachedCall.LIMIT_MILLIS);
        dialogue.send(command, answer -> {
            if (underWay == key) {
                long left = Math.max(1, began + TONE_NANOS - timers.nowNanos());
                timer = timers.start(answer.isOk() ? left : 1, () -> ended(key, answer.isOk()));
            }
        });
    }

    /** The tone has ended; called for one in the sound. */
    void ended(DtmfKey key, boolean isSent) {
        underWay = null;
        ended.accept(key, isSent);
        if (underWay == null) {
            next();
        }
    }
}
