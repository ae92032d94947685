package simgsm.abis;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.air.ProtocolViolation;
import simgsm.net.Connection;
import simgsm.net.OutputQueue;
import simgsm.timer.RateLimit;

/**
 * A connection that carries IPA frames, at a station's end or at the centre's. While the peer keeps up, each frame leaves in
 * a write of its own; else signalling waits in order, and of the speech the last 200 ms.
 */
public abstract class IpaConnection extends Connection {
    /** 200 ms of speech at 20 ms a frame. */
    private static final int MOST_SPEECH_FRAMES = 10;
    /** After a portion that was too fast; at 1 000 frames/s ten frames are due again then. */
    private static final long PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    private static final System.Logger LOG = System.getLogger(IpaConnection.class.getName());

    private final RateLimitedFrameReader reader;
    private final OutputQueue output;

    /**
     * @param rate at which frames are read
     * @param mostSignallingFrames a peer that leaves more than these untaken is disconnected
     * @param written called with each frame, as it is on the wire, after its last octet has been written
     */
    protected IpaConnection(Endpoint endpoint, RateLimit rate, int mostSignallingFrames, Consumer<byte[]> written) {
        super(endpoint);
        reader = new RateLimitedFrameReader(rate);
        output = new OutputQueue(mostSignallingFrames, MOST_SPEECH_FRAMES, written);
    }

    protected abstract void frameArrived(IpaFrame frame);

    /** Sends or queues a frame; on a connection that is not open the frame is lost. */
    public final void send(IpaFrame frame) {
        if (isOpen()) {
            boolean isFirst = output.isEmpty();
            if (!output.add(IpaFramer.encode(frame), frame.stream() == IpaFrame.SPEECH)) {
                fail(output.size() + " frames not taken");
            } else if (isFirst) {
                flush();
            }
        }
    }

    @Override
    protected final void received(ByteBuffer octets) {
        reader.accept(octets);
        readPortion();
    }

    private void readPortion() {
        try {
            switch (reader.read(System.nanoTime(), this::pass)) {
                case COMPLETE -> resumeReading();
                case FULL -> continueAfter(0);
                case TOO_FAST -> continueAfter(PAUSE_NANOS);
            }
        } catch (ProtocolViolation violation) {
            fail(violation.getMessage());
        }
    }

    private void continueAfter(long pauseNanos) {
        pauseReading();
        after(pauseNanos, this::readPortion);
    }

    private void pass(IpaFrame frame) {
        if (isOpen()) {
            frameArrived(frame);
        }
    }

    @Override
    public final boolean hasOutput() {
        return !output.isEmpty();
    }

    @Override
    protected final void writeTo(WritableByteChannel channel) throws IOException {
        output.flush(channel);
    }

    @Override
    protected void closing(boolean isByPeer) {
        if (output.dropped() > 0) {
            LOG.log(Level.INFO, "{0}: {1} speech frames dropped, the peer was too slow", address(), output.dropped());
        }
    }
}
