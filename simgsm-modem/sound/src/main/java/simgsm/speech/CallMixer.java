package simgsm.speech;

import java.util.ArrayDeque;
import java.util.Deque;

/** Mixes both directions of a call, one frame for each frame sent. */
public final class CallMixer {
    /** Most waiting received frames; in a longer burst the oldest is dropped. */
    private static final int MAX_WAITING = 3;

    private final Deque<short[]> waiting = new ArrayDeque<>();

    /** A mixer for a new call. */
    public CallMixer() {}

    /** Takes 20 ms of the other end, for the next frame sent. */
    public void received(short[] frame) {
        if (waiting.size() == MAX_WAITING) {
            waiting.remove();
        }
        waiting.add(frame.clone());
    }

    /** Takes 20 ms of this end. @return a new frame with the sum of both, saturated */
    public short[] sent(short[] frame) {
        short[] far = waiting.poll();
        return far == null ? frame.clone() : sum(frame, far);
    }

    /** A new frame with the sum of two, saturated. */
    public static short[] sum(short[] one, short[] other) {
        short[] sum = one.clone();
        for (int i = 0; i < sum.length; i++) {
            sum[i] = (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, sum[i] + other[i]));
        }
        return sum;
    }

    /** Drops waiting frames at the end of the call. */
    public void clear() {
        waiting.clear();
    }
}
