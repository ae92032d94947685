package blackbox.fuzz;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.Optional;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.air.ProtocolViolation;

/** A fuzz station's connection to the centre, replaced when either side closes it. */
final class FuzzConnection {
    /** Attempts to write; octets that the centre has not accepted by then are lost. */
    private static final int MOST_WRITES = 100;

    private final FuzzStation station;
    /** Null without a connection. */
    private SocketChannel channel;

    private IpaFramer framer = new IpaFramer();
    private boolean isBroken;
    private long connections;

    FuzzConnection(FuzzStation station) {
        this.station = station;
    }

    long frames() {
        return station.frames();
    }

    /** @throws AssertionError if the centre cannot be reached or breaks the protocol */
    void turn(InetSocketAddress center, ByteBuffer buffer, long nowNanos) {
        if (channel == null) {
            connect(center, nowNanos);
        }
        read(buffer, nowNanos);
        station.turn(nowNanos);
        if (isBroken || station.wantsNewConnection()) {
            close();
            station.disconnected(nowNanos);
        }
    }

    private void connect(InetSocketAddress center, long nowNanos) {
        try {
            channel = SocketChannel.open(center);
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
        } catch (IOException e) {
            throw new AssertionError(
                    "after " + connections + " connections of this station the centre cannot be reached: "
                            + e.getMessage(),
                    e);
        }
        connections++;
        framer = new IpaFramer();
        isBroken = false;
        station.connected(this::write, nowNanos);
    }

    private void read(ByteBuffer buffer, long nowNanos) {
        try {
            buffer.clear();
            isBroken |= channel.read(buffer) < 0;
            framer.accept(buffer.flip());
            for (Optional<IpaFrame> frame = framer.next(); frame.isPresent(); frame = framer.next()) {
                station.arrived(frame.get(), nowNanos);
            }
        } catch (IOException e) {
            isBroken = true;
        } catch (ProtocolViolation violation) {
            throw new AssertionError("the centre breaks the protocol: " + violation.getMessage(), violation);
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
