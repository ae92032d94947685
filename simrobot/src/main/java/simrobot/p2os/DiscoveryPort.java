package simrobot.p2os;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.DatagramChannel;
import simgsm.thread.DaemonThread;

/**
 * Answers the search for simulators in a network, as MobileSim does: a datagram {@code 00 00 00 F6} is answered by 30
 * octets, zero but for F7 at 3, FA at 8 and FB at 9 (Lantronix discovery). A separate thread reads the port.
 */
public final class DiscoveryPort implements AutoCloseable {
    /** MobileSim's port. */
    public static final int USUAL_PORT = 30718;

    private static final Logger LOG = System.getLogger(DiscoveryPort.class.getName());
    private static final int REQUEST = 0xF6;
    private static final int REQUEST_LENGTH = 4;
    private static final int TYPE_AT = 3;
    private static final int ANSWER_LENGTH = 30;
    private static final int ANSWER = 0xF7;
    private static final int MARK_AT = 8;

    private final DatagramChannel channel;

    private DiscoveryPort(DatagramChannel channel) {
        this.channel = channel;
    }

    /** Opens the port. @throws IOException if it is in use, usually by another simulator on this machine */
    public static DiscoveryPort open(InetSocketAddress address) throws IOException {
        DatagramChannel channel = DatagramChannel.open();
        try {
            channel.bind(address);
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
        return new DiscoveryPort(channel);
    }

    /** The port's number. */
    public int port() throws IOException {
        return ((InetSocketAddress) channel.getLocalAddress()).getPort();
    }

    /** Starts answering. */
    public void start() {
        DaemonThread.start("p2os discovery", this::serve);
    }

    private void serve() {
        ByteBuffer request = ByteBuffer.allocate(REQUEST_LENGTH);
        try {
            while (true) {
                SocketAddress asking = channel.receive(request.clear());
                if (request.position() == REQUEST_LENGTH && (request.get(TYPE_AT) & 0xFF) == REQUEST) {
                    answer(asking);
                }
            }
        } catch (ClosedChannelException closed) {
            LOG.log(Level.DEBUG, "discovery ends");
        } catch (IOException e) {
            LOG.log(Level.WARNING, "discovery on UDP ends: " + e.getMessage());
        }
    }

    /** Answers a host; a failure, such as a missing route, loses this answer only. */
    private void answer(SocketAddress asking) throws ClosedChannelException {
        try {
            channel.send(answer(), asking);
        } catch (ClosedChannelException closed) {
            throw closed;
        } catch (IOException unreachable) {
            LOG.log(Level.DEBUG, "no answer to " + asking + ": " + unreachable.getMessage());
        }
    }

    private static ByteBuffer answer() {
        return ByteBuffer.allocate(ANSWER_LENGTH)
                .put(TYPE_AT, (byte) ANSWER)
                .put(MARK_AT, (byte) P2osPacket.HEADER_1)
                .put(MARK_AT + 1, (byte) P2osPacket.HEADER_2);
    }

    @Override
    public void close() {
        try {
            channel.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing the discovery port failed", e);
        }
    }
}
