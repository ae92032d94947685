package simgsm.speech;

import java.util.ArrayDeque;
import java.util.Deque;

/** What is heard at one end of a call: both directions at once. What is sent gives the beat. */
public final class CallMix {
    /** More than this waits only when received frames come in a burst; the oldest is then dropped. */
    private static final int MAX_WAITING = 3;

    private final Deque<short[]> waiting = new ArrayDeque<>();

    /** Nothing has been heard yet. */
    public CallMix() {}

    /** 20 ms from the far end; heard with the next that is sent. */
    public void received(short[] frame) {
        if (waiting.size() == MAX_WAITING) {
            waiting.remove();
        }
        waiting.add(frame.clone());
    }

    /** 20 ms of one's own. @return what is heard meanwhile, the caller's to keep */
    public short[] sent(short[] frame) {
        short[] mixed = frame.clone();
        short[] far = waiting.poll();
        if (far != null) {
            for (int i = 0; i < mixed.length; i++) {
                mixed[i] = (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, mixed[i] + far[i]));
            }
        }
        return mixed;
    }

    /** The call is over: what still waits is heard no more. */
    public void clear() {
        waiting.clear();
    }
}
