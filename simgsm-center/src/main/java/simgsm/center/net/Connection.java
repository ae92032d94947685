package simgsm.center.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import simgsm.abis.IpaFrame;
import simgsm.abis.OutgoingFrames;
import simgsm.air.ProtocolViolation;
import simgsm.center.capture.WireTap;
import simgsm.center.msc.Link;
import simgsm.center.msc.LinkPort;

/** One terminal's TCP connection: octets in, frames to the loop; frames in, octets out. */
final class Connection extends Peer implements LinkPort {
    /** What the connection needs beside its loop's usual services. */
    interface Host extends Peer.Host {
        void frameArrived(Connection connection, IpaFrame frame);

        void lost(Connection connection, String reason);

        long nowNanos();

        /** The connection has frames to hand on, and waits for {@link Connection#turn}. */
        void awaitsTurn(Connection connection, RateLimitedFrameReader.Rest rest);
    }

    private static final System.Logger LOG = System.getLogger(Connection.class.getName());
    /** Many terminals may fall behind at once. */
    private static final int MOST_SIGNALLING_FRAMES = 2_000;

    private final Host host;
    private final RateLimitedFrameReader intake;
    private final WireTap tap;
    private final OutgoingFrames outgoing;
    private boolean isBehind;

    /** What this connection is to the exchange. */
    Link link;

    Connection(Incoming incoming, Host host, WireTap tap) {
        super(incoming, host);
        this.host = host;
        this.tap = tap;
        this.intake = new RateLimitedFrameReader(address().isLoopbackAddress());
        this.outgoing = new OutgoingFrames(MOST_SIGNALLING_FRAMES, tap::sent);
    }

    @Override
    void received(ByteBuffer octets) {
        intake.accept(octets);
        turn();
    }

    /** Hands on a portion of the frames that have come; until all are, nothing further is read. */
    void turn() {
        if (!isOpen()) {
            return;
        }
        try {
            RateLimitedFrameReader.Rest rest = intake.hand(host.nowNanos(), this::arrived);
            isBehind = rest != RateLimitedFrameReader.Rest.NONE;
            if (isBehind) {
                host.awaitsTurn(this, rest);
            }
            listen();
        } catch (ProtocolViolation violation) {
            broken(violation.getMessage());
        }
    }

    private void arrived(IpaFrame frame) {
        if (isOpen()) {
            tap.received(frame);
            host.frameArrived(this, frame);
        }
    }

    @Override
    boolean wantsToRead() {
        return !isBehind;
    }

    @Override
    boolean wantsToWrite() {
        return !outgoing.isEmpty();
    }

    @Override
    void flush(WritableByteChannel channel) throws IOException {
        outgoing.flush(channel);
    }

    @Override
    public void send(IpaFrame frame) {
        transmit(channel -> {
            if (!outgoing.send(frame, channel)) {
                broken(outgoing.size() + " frames not taken");
            }
        });
    }

    @Override
    public void close(String reason) {
        shut();
    }

    @Override
    void closing(boolean isByPeer) {
        if (outgoing.droppedSpeechFrames() > 0) {
            LOG.log(Level.INFO, "{0}: too slow for {1} speech frames", link, outgoing.droppedSpeechFrames());
        }
        tap.closed(isByPeer);
    }

    @Override
    void lost(String reason) {
        host.lost(this, reason);
    }
}
