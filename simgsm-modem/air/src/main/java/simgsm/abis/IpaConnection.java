package simgsm.abis;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.air.ProtocolViolation;
import simgsm.net.Datagrams;
import simgsm.net.OutputQueue;
import simgsm.net.QueuedConnection;
import simgsm.timer.RateLimit;

/**
 * A connection with IPA frames, at a station's or the centre's end. While the peer keeps up, each frame is written
 * separately; else signalling waits in order, and only the last 200 ms of speech are kept. Speech can be sent as RTP
 * over UDP, to the peer's host only.
 */
public abstract class IpaConnection extends QueuedConnection implements MediaPort {
    /** 200 ms of speech at 20 ms a frame. */
    private static final int MOST_SPEECH_FRAMES = 10;
    /** Pause after a portion above the rate; ten frames at 1 000 frames/s. */
    private static final long PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(10);

    private static final System.Logger LOG = System.getLogger(IpaConnection.class.getName());

    private final RateLimitedFrameReader reader;
    private final MediaSocket media = new MediaSocket(this, this::mediaArrived);
    private final List<MediaSocket> further = new ArrayList<>();

    /**
     * @param rate limit of reading frames
     * @param mostSignallingFrames limit of untaken frames, above which the peer is disconnected
     * @param written called with each frame, as it is on the wire, after its last octet has been written
     */
    protected IpaConnection(Endpoint endpoint, RateLimit rate, int mostSignallingFrames, Consumer<byte[]> written) {
        super(endpoint, new OutputQueue(mostSignallingFrames, MOST_SPEECH_FRAMES, written));
        reader = new RateLimitedFrameReader(rate);
    }

    protected abstract void frameArrived(IpaFrame frame);

    /** Sends or queues a frame; it is lost if the connection is not open. */
    public final void send(IpaFrame frame) {
        if (isOpen() && !write(IpaFramer.encode(frame), frame.stream() == IpaFrame.SPEECH)) {
            fail(output().size() + " frames not taken");
        }
    }

    @Override
    public final Optional<MediaAddress> openMedia() {
        return media.openMedia();
    }

    @Override
    public final boolean connectMedia(MediaAddress peer) {
        return media.connectMedia(peer);
    }

    @Override
    public final boolean sendMedia(byte[] rtp) {
        return media.sendMedia(rtp);
    }

    @Override
    public final void closeMedia() {
        media.closeMedia();
    }

    /** A further socket for speech, which ends with this connection. @param received receives each packet */
    protected final MediaPort furtherMedia(Consumer<byte[]> received) {
        further.removeIf(MediaSocket::isClosed);
        MediaSocket socket = new MediaSocket(this, received);
        further.add(socket);
        return socket;
    }

    /** A socket for datagrams, on the thread of this connection. */
    final Datagrams datagrams(Consumer<byte[]> received) throws IOException {
        return openDatagrams(received);
    }

    private void mediaArrived(byte[] rtp) {
        speechArrived(new IpaFrame(IpaFrame.SPEECH, rtp));
    }

    /** A speech frame was received as a datagram. */
    protected void speechArrived(IpaFrame frame) {
        frameArrived(frame);
    }

    /** A speech datagram was sent or received. */
    protected void mediaPassed(boolean isFromPeer, int peerPort, int ownPort, byte[] rtp) {}

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
    protected void closing(boolean isByPeer) {
        closeMedia();
        further.forEach(MediaSocket::closeMedia);
        if (output().dropped() > 0) {
            LOG.log(Level.INFO, "{0}: {1} speech frames dropped, the peer was too slow", address(), output().dropped());
        }
    }
}
