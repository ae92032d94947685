package simgsm.center.net;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.air.ProtocolViolation;
import simgsm.timer.RateLimit;

/**
 * A terminal's frames, in portions: whoever sends more than a few at a time waits for the others' turns, and whoever sends
 * more than anybody needs is read no faster than that. Nothing is lost; the peer is held back by its own full socket.
 */
final class RateLimitedFrameReader {
    /** Of one peer before the others have theirs: well below a millisecond's work. */
    static final int FRAMES_A_TURN = 64;
    /**
     * From another machine: twenty times a call with all its keys; and the burst is more speech than any peer keeps back.
     */
    static final int REMOTE_FRAMES_PER_SECOND = 1_000;

    static final int REMOTE_BURST_FRAMES = 2_000;
    /** On this machine: a phone that is given thousands of short messages a second. */
    static final int LOCAL_FRAMES_PER_SECOND = 20_000;

    static final int LOCAL_BURST_FRAMES = 20_000;

    /** How a portion has ended. */
    enum Rest {
        /** All that has come is done. */
        NONE,
        /** More is there; the others first. */
        FOR_ANOTHER_TURN,
        /** More is there, and too fast. */
        FOR_LATER
    }

    private final IpaFramer framer = new IpaFramer();
    private final RateLimit frames;

    RateLimitedFrameReader(boolean isLocal) {
        frames = isLocal
                ? new RateLimit(LOCAL_FRAMES_PER_SECOND, LOCAL_BURST_FRAMES)
                : new RateLimit(REMOTE_FRAMES_PER_SECOND, REMOTE_BURST_FRAMES);
    }

    /** Takes octets; not before the last portion has ended with {@link Rest#NONE}, or memory would grow with the flood. */
    void accept(ByteBuffer octets) {
        framer.accept(octets);
    }

    /**
     * Hands on a portion of what has come.
     *
     * @param receiver takes each frame, and may end the connection with it
     */
    Rest hand(long nowNanos, Consumer<IpaFrame> receiver) throws ProtocolViolation {
        for (int count = 0; count < FRAMES_A_TURN; count++) {
            if (!frames.isLeft(nowNanos)) {
                return Rest.FOR_LATER;
            }
            Optional<IpaFrame> frame = framer.next();
            if (frame.isEmpty()) {
                return Rest.NONE;
            }
            frames.take(nowNanos);
            receiver.accept(frame.get());
        }
        return Rest.FOR_ANOTHER_TURN;
    }
}
