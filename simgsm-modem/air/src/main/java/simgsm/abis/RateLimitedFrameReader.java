package simgsm.abis;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.air.ProtocolViolation;
import simgsm.timer.RateLimit;

/**
 * Reads the frames of one peer in portions, limited to a rate. Nothing is dropped: while frames are left, the owner
 * reads no further octets, which holds the peer back by its own full socket buffer.
 */
public final class RateLimitedFrameReader {
    /** Frames per portion: well below a millisecond's work. */
    public static final int FRAMES_PER_PORTION = 64;

    /** The end of a portion. */
    public enum Portion {
        /** No whole frame is left. */
        COMPLETE,
        /** Frames are left; other peers are served first. */
        FULL,
        /** Frames are left, and the peer is above its rate. */
        TOO_FAST
    }

    private final IpaFramer framer = new IpaFramer();
    private final RateLimit rate;

    /** @param rate in frames */
    public RateLimitedFrameReader(RateLimit rate) {
        this.rate = rate;
    }

    /** Takes octets; call only after a {@link Portion#COMPLETE} portion, so that memory stays bounded. */
    public void accept(ByteBuffer octets) {
        framer.accept(octets);
    }

    /** Passes a portion of the frames to the receiver. */
    public Portion read(long nowNanos, Consumer<IpaFrame> receiver) throws ProtocolViolation {
        for (int count = 0; count < FRAMES_PER_PORTION; count++) {
            if (!rate.isLeft(nowNanos)) {
                return Portion.TOO_FAST;
            }
            Optional<IpaFrame> frame = framer.next();
            if (frame.isEmpty()) {
                return Portion.COMPLETE;
            }
            rate.take(nowNanos);
            receiver.accept(frame.get());
        }
        return Portion.FULL;
    }
}
