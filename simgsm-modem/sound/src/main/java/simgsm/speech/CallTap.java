package simgsm.speech;

/**
 * Somebody who listens in on a station's calls, both directions. Told on the station's thread, so it never waits; frames
 * are 20 ms, 8 kHz, 16 bit, and nobody changes them afterwards.
 */
public interface CallTap {
    /** Nobody listens in. */
    CallTap NONE = new CallTap() {};

    /** A call is active from now on. */
    default void callBegan() {}

    default void sent(short[] frame) {}

    /** Frames that were lost come as silence. */
    default void received(short[] frame) {}

    default void callEnded() {}

    /** The station is no more. */
    default void close() {}

    /** Two who listen in on the same calls. */
    static CallTap both(CallTap one, CallTap other) {
        return new CallTap() {
            @Override
            public void callBegan() {
                one.callBegan();
                other.callBegan();
            }

            @Override
            public void sent(short[] frame) {
                one.sent(frame);
                other.sent(frame);
            }

            @Override
            public void received(short[] frame) {
                one.received(frame);
                other.received(frame);
            }

            @Override
            public void callEnded() {
                one.callEnded();
                other.callEnded();
            }

            @Override
            public void close() {
                one.close();
                other.close();
            }
        };
    }
}
