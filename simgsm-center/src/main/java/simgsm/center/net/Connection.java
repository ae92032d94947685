package simgsm.center.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.Optional;
import simgsm.air.IpaFrame;
import simgsm.air.IpaFramer;
import simgsm.air.ProtocolViolation;
import simgsm.center.capture.WireTap;
import simgsm.center.msc.Link;
import simgsm.center.msc.LinkPort;
import simgsm.station.OutgoingFrames;

/** One terminal's TCP connection: octets in, frames to the loop; frames in, octets out. */
final class Connection implements Peer, LinkPort {
    /** What a connection asks of its loop. */
    interface Host extends Peer.Host {
        void frameArrived(Connection connection, IpaFrame frame);

        void lost(Connection connection, String reason);
    }

    private static final System.Logger LOG = System.getLogger(Connection.class.getName());
    /** Many terminals may fall behind at once. */
    private static final int MOST_SIGNALLING_FRAMES = 2_000;

    private final SocketChannel channel;
    private final SelectionKey key;
    private final Host host;
    private final IpaFramer framer = new IpaFramer();
    private final WireTap tap;
    private final OutgoingFrames outgoing;

    /** What this connection is to the exchange. */
    Link link;

    private boolean isOpen = true;
    private boolean hasPeerLeft;

    Connection(SocketChannel channel, SelectionKey key, Host host, WireTap tap) {
        this.channel = channel;
        this.key = key;
        this.host = host;
        this.tap = tap;
        this.outgoing = new OutgoingFrames(MOST_SIGNALLING_FRAMES, tap::sent);
    }

    @Override
    public boolean isOpen() {
        return isOpen;
    }

    @Override
    public void readable(ByteBuffer buffer) {
        try {
            buffer.clear();
            if (channel.read(buffer) < 0) {
                hasPeerLeft = true;
                host.broken(this, "closed by the peer");
                return;
            }
            buffer.flip();
            framer.accept(buffer);
            for (Optional<IpaFrame> frame = framer.next(); frame.isPresent() && isOpen; frame = framer.next()) {
                tap.received(frame.get());
                host.frameArrived(this, frame.get());
            }
        } catch (IOException e) {
            host.broken(this, String.valueOf(e.getMessage()));
        } catch (ProtocolViolation violation) {
            host.broken(this, violation.getMessage());
        }
    }

    @Override
    public void writable() {
        try {
            outgoing.flush(channel);
            listenForRoom();
        } catch (IOException e) {
            host.broken(this, String.valueOf(e.getMessage()));
        }
    }

    @Override
    public void send(IpaFrame frame) {
        if (!isOpen) {
            return;
        }
        try {
            if (!outgoing.send(frame, channel)) {
                host.broken(this, outgoing.size() + " frames not taken");
            }
            listenForRoom();
        } catch (IOException e) {
            host.broken(this, String.valueOf(e.getMessage()));
        }
    }

    private void listenForRoom() {
        int wanted = outgoing.isEmpty() ? SelectionKey.OP_READ : SelectionKey.OP_READ | SelectionKey.OP_WRITE;
        if (key.isValid() && key.interestOps() != wanted) {
            key.interestOps(wanted);
        }
    }

    @Override
    public void close(String reason) {
        shut();
    }

    @Override
    public void lost(String reason) {
        host.lost(this, reason);
    }

    @Override
    public void shut() {
        if (!isOpen) {
            return;
        }
        isOpen = false;
        if (outgoing.droppedSpeechFrames() > 0) {
            LOG.log(Level.INFO, "{0}: too slow for {1} speech frames", link, outgoing.droppedSpeechFrames());
        }
        tap.closed(hasPeerLeft);
        host.closed(this);
        key.cancel();
        try {
            channel.close();
        } catch (IOException e) {
            // It is gone either way.
        }
    }
}
