package simgsm.tools.fuzz;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.Optional;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.air.ProtocolViolation;

/** A peer's connection to the centre, made anew whenever either side has had enough of it. */
final class FuzzSocket {
    /** A centre that takes no more for now is let breathe; what it does not take at all is lost. */
    private static final int MOST_WRITES = 100;

    private final FuzzPeer peer;
    /** Null while there is none. */
    private SocketChannel channel;

    private IpaFramer framer = new IpaFramer();
    private boolean isBroken;
    private long connections;

    FuzzSocket(FuzzPeer peer) {
        this.peer = peer;
    }

    long frames() {
        return peer.frames();
    }

    long connections() {
        return connections;
    }

    /** @throws Finding if the centre cannot be reached, or breaks the protocol itself */
    void turn(InetSocketAddress center, ByteBuffer buffer, long nowNanos) {
        if (channel == null) {
            connect(center, nowNanos);
        }
        read(buffer, nowNanos);
        peer.turn(nowNanos);
        if (isBroken || peer.wantsToLeave()) {
            close();
            peer.disconnected(nowNanos);
        }
    }

    private void connect(InetSocketAddress center, long nowNanos) {
        try {
            channel = SocketChannel.open(center);
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
        } catch (IOException e) {
            throw new Finding(
                    "after " + connections + " connections of this peer the centre is gone: " + e.getMessage(), e);
        }
        connections++;
        framer = new IpaFramer();
        isBroken = false;
        peer.connected(this::write, nowNanos);
    }

    private void read(ByteBuffer buffer, long nowNanos) {
        try {
            buffer.clear();
            isBroken |= channel.read(buffer) < 0;
            framer.accept(buffer.flip());
            for (Optional<IpaFrame> frame = framer.next(); frame.isPresent(); frame = framer.next()) {
                peer.arrived(frame.get(), nowNanos);
            }
        } catch (IOException e) {
            isBroken = true;
        } catch (ProtocolViolation violation) {
            throw new Finding("the centre itself breaks the protocol: " + violation.getMessage(), violation);
        }
    }

    private void write(byte[] octets) {
        ByteBuffer out = ByteBuffer.wrap(octets);
        try {
            for (int writes = 0; out.hasRemaining() && !isBroken && writes < MOST_WRITES; writes++) {
                if (channel.write(out) == 0) {
                    Thread.onSpinWait();
                }
            }
            isBroken |= out.hasRemaining();
        } catch (IOException e) {
            isBroken = true;
        }
    }

    void close() {
        if (channel != null) {
            try {
                channel.close();
            } catch (IOException e) {
                isBroken = true;
            }
            channel = null;
        }
    }
}
