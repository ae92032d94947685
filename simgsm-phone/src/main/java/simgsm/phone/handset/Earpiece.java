package simgsm.phone.handset;

import java.util.ArrayDeque;
import java.util.Deque;
import simgsm.dtmf.ToneTrace;
import simgsm.dtmf.ToneTracer;
import simgsm.speech.AudioOutput;

/** What is heard at the ear and seen on the scope: the far end's speech and, softer, one's own. */
final class Earpiece {
    /** More than this waits only when the far end's frames come in a burst; the oldest is then dropped. */
    private static final int MAX_WAITING = 3;

    private final AudioOutput output;
    private final ToneTracer tracer = new ToneTracer();
    private final Deque<short[]> waiting = new ArrayDeque<>();
    private boolean changed;

    Earpiece(AudioOutput output) {
        this.output = output;
    }

    /** 20 ms from the far end; heard with the next that is said. */
    void heard(short[] frame) {
        if (waiting.size() == MAX_WAITING) {
            waiting.remove();
        }
        waiting.add(frame.clone());
    }

    /** 20 ms of one's own; it gives the beat. */
    void said(short[] frame) {
        short[] mixed = frame.clone();
        short[] far = waiting.poll();
        if (far != null) {
            for (int i = 0; i < mixed.length; i++) {
                int sum = mixed[i] + far[i];
                mixed[i] = (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, sum));
            }
        }
        output.play(mixed);
        changed |= tracer.accept(mixed);
    }

    void callEnded() {
        waiting.clear();
    }

    ToneTrace trace() {
        return tracer.newest();
    }

    boolean isAudible() {
        return output.isAudible();
    }

    /** Whether the picture has changed since this was asked last. */
    boolean pollChanged() {
        boolean was = changed;
        changed = false;
        return was;
    }
}
