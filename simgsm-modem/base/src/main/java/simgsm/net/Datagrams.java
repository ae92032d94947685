package simgsm.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.util.function.BiConsumer;
import java.util.function.Consumer;

/**
 * A UDP socket of a {@link SelectorLoop}: with one peer, the system dropping datagrams of others, or with any number
 * of peers. All methods belong to the loop's thread.
 */
public final class Datagrams {
    private static final System.Logger LOG = System.getLogger(Datagrams.class.getName());
    /** Longer datagrams of the one peer are cut. */
    private static final int MOST_OCTETS = 2_048;

    private static final int READS_PER_ITERATION = 16;
    /** RTP is received on an even port (RFC 3550, 11); every second port given by the system is even. */
    private static final int ATTEMPTS = 20;

    private final SelectorLoop loop;
    private final DatagramChannel channel;
    private final BiConsumer<byte[], InetSocketAddress> received;
    private final boolean hasManyPeers;
    private final ByteBuffer buffer;
    private boolean isConnected;

    private Datagrams(
            SelectorLoop loop,
            DatagramChannel channel,
            boolean hasManyPeers,
            BiConsumer<byte[], InetSocketAddress> received)
            throws IOException {
        this.loop = loop;
        this.channel = channel;
        this.hasManyPeers = hasManyPeers;
        this.received = received;
        buffer = hasManyPeers ? loop.readBuffer() : ByteBuffer.allocate(MOST_OCTETS);
        channel.configureBlocking(false);
        channel.register(loop.selector(), SelectionKey.OP_READ, (Runnable) this::read);
    }

    /** Opens a free even port of this address. @param received takes each datagram of the peer */
    static Datagrams open(SelectorLoop loop, InetAddress local, Consumer<byte[]> received) throws IOException {
        return openEven(loop, local, false, (octets, peer) -> received.accept(octets));
    }

    /**
     * Opens a socket for any number of peers.
     *
     * @param local port 0 for any free even one
     * @param received takes each datagram with its source
     * @throws IOException naming address and port
     */
    static Datagrams open(SelectorLoop loop, InetSocketAddress local, BiConsumer<byte[], InetSocketAddress> received)
            throws IOException {
        if (local.getPort() == 0) {
            return openEven(loop, local.getAddress(), true, received);
        }
        DatagramChannel channel = DatagramChannel.open();
        try {
            channel.bind(local);
            return new Datagrams(loop, channel, true, received);
        } catch (IOException e) {
            channel.close();
            throw new IOException(
                    "cannot open UDP port " + local.getPort() + " of "
                            + local.getAddress().getHostAddress() + ": " + e.getMessage(),
                    e);
        }
    }

    private static Datagrams openEven(
            SelectorLoop loop, InetAddress local, boolean hasManyPeers, BiConsumer<byte[], InetSocketAddress> received)
            throws IOException {
        for (int attempt = 1; attempt <= ATTEMPTS; attempt++) {
            DatagramChannel channel = DatagramChannel.open();
            try {
                channel.bind(new InetSocketAddress(local, 0));
                if (channel.socket().getLocalPort() % 2 == 0) {
                    return new Datagrams(loop, channel, hasManyPeers, received);
                }
                channel.close();
            } catch (IOException e) {
                channel.close();
                throw e;
            }
        }
        throw new IOException("no even UDP port is free on " + local.getHostAddress());
    }

    /** Receives datagrams. */
    public InetSocketAddress localAddress() {
        return (InetSocketAddress) channel.socket().getLocalSocketAddress();
    }

    /** Sends to this address, and receives from no other. */
    public void connect(InetSocketAddress peer) throws IOException {
        channel.connect(peer);
        isConnected = true;
    }

    /** Sends a datagram; it is lost if the system does not take it at once. @return false if no peer is connected */
    public boolean send(byte[] octets) {
        if (isConnected) {
            try {
                channel.write(ByteBuffer.wrap(octets));
            } catch (IOException e) {
                LOG.log(Level.DEBUG, "a datagram is lost: {0}", Connection.reason(e));
            }
        }
        return isConnected;
    }

    /** Sends a datagram to one of many peers; it is lost if the system does not take it at once. */
    public void send(byte[] octets, InetSocketAddress to) {
        try {
            channel.send(ByteBuffer.wrap(octets), to);
        } catch (IOException | RuntimeException e) {
            LOG.log(Level.DEBUG, "a datagram to {0} is lost: {1}", to, e.getMessage());
        }
    }

    private void read() {
        try {
            for (int i = 0; i < READS_PER_ITERATION && channel.isOpen(); i++) {
                buffer.clear();
                // Before the peer is known, datagrams are read and dropped.
                InetSocketAddress from = (InetSocketAddress) channel.receive(buffer);
                if (from == null) {
                    return;
                }
                if (isConnected || hasManyPeers) {
                    byte[] octets = new byte[buffer.flip().remaining()];
                    buffer.get(octets);
                    loop.perform(() -> received.accept(octets, from));
                }
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "reading datagrams: {0}", Connection.reason(e));
        }
    }

    /** Closes the socket. */
    public void close() {
        try {
            channel.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a UDP socket: {0}", Connection.reason(e));
        }
    }
}
