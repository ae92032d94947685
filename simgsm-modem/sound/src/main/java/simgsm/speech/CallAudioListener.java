package simgsm.speech;

/**
 * Receives the speech of a station's calls in both directions, on the station's thread; it must not block. Frames are
 * 20 ms, 8 kHz, 16 bit, and do not change afterwards.
 */
public interface CallAudioListener {
    /** Ignores all calls. */
    CallAudioListener NONE = new CallAudioListener() {};

    /** A call has become active. */
    default void callBegan() {}

    default void sent(short[] frame) {}

    /** Lost frames are silence. */
    default void received(short[] frame) {}

    default void callEnded() {}

    /** The station is removed. */
    default void close() {}

    /** A listener that forwards to two. */
    static CallAudioListener both(CallAudioListener one, CallAudioListener other) {
        return new CallAudioListener() {
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
