package simgsm.center.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;

/** One port that the loop listens on, and how many may come in by it. */
final class Acceptor {
    private static final System.Logger LOG = System.getLogger(Acceptor.class.getName());
    private static final int BACKLOG = 1_024;
    /** So many at a time. */
    private static final int ACCEPTED_A_TURN = 64;

    private static final int LOGGED_EACH = 1_000;
    /** A pause before accepting again when the process may open no more files. */
    private static final long ACCEPT_PAUSE_NANOS = 500_000_000;

    /** Makes something of an accepted connection. */
    interface Welcome {
        Peer peer(Peer.Incoming incoming);
    }

    private final ServerSocketChannel server;
    private final SelectionKey key;
    private final ConnectionLimits admissions;
    private final Welcome welcome;
    private long turnedAway;
    private long acceptAgainNanos = Long.MAX_VALUE;

    private Acceptor(ServerSocketChannel server, SelectionKey key, ConnectionLimits admissions, Welcome welcome) {
        this.server = server;
        this.key = key;
        this.admissions = admissions;
        this.welcome = welcome;
    }

    /**
     * Opens a port.
     *
     * @param port 0 for any free one
     * @throws IOException naming address and port
     */
    static Acceptor open(Selector selector, InetAddress address, int port, ConnectionLimits admissions, Welcome welcome)
            throws IOException {
        ServerSocketChannel server = ServerSocketChannel.open();
        try {
            server.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            server.bind(new InetSocketAddress(address, port), BACKLOG);
            server.configureBlocking(false);
            SelectionKey key = server.register(selector, SelectionKey.OP_ACCEPT);
            Acceptor door = new Acceptor(server, key, admissions, welcome);
            key.attach(door);
            return door;
        } catch (IOException e) {
            server.close();
            throw new IOException(
                    "cannot listen on " + address.getHostAddress() + " port " + port + ": " + e.getMessage(), e);
        }
    }

    int port() {
        return server.socket().getLocalPort();
    }

    /** Lets in whoever waits; the rest of a crowd at the next turn, after those who are in already. */
    void accept(long nowNanos) {
        try {
            SocketChannel channel = server.accept();
            for (int count = 1; channel != null; count++) {
                let(channel);
                channel = count < ACCEPTED_A_TURN ? server.accept() : null;
            }
        } catch (IOException e) {
            LOG.log(Level.WARNING, "cannot accept: {0}; trying again soon", e.getMessage());
            key.interestOps(0);
            acceptAgainNanos = nowNanos + ACCEPT_PAUSE_NANOS;
        }
    }

    private void let(SocketChannel channel) throws IOException {
        try {
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            InetSocketAddress address = (InetSocketAddress) channel.getRemoteAddress();
            SelectionKey peerKey = channel.register(key.selector(), SelectionKey.OP_READ);
            if (admissions.admit(address.getAddress())) {
                peerKey.attach(welcome.peer(new Peer.Incoming(channel, peerKey, address)));
            } else {
                turnAway(channel, address);
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a peer left before it was welcomed: {0}", e.getMessage());
            channel.close();
        }
    }

    /** A flood must not fill the log either. */
    private void turnAway(SocketChannel channel, InetSocketAddress address) throws IOException {
        turnedAway++;
        LOG.log(
                turnedAway % LOGGED_EACH == 1 ? Level.WARNING : Level.DEBUG,
                "{0}: turned away, {1} connections are open; the {2}. so far",
                address,
                admissions.open(),
                turnedAway);
        channel.close();
    }

    /** One of those who came in has gone. */
    void left(Peer peer) {
        admissions.left(peer.address());
    }

    /** When to call {@link #acceptAgain}. */
    long acceptAgainNanos() {
        return acceptAgainNanos;
    }

    void acceptAgain(long nowNanos) {
        if (nowNanos >= acceptAgainNanos) {
            acceptAgainNanos = Long.MAX_VALUE;
            key.interestOps(SelectionKey.OP_ACCEPT);
        }
    }

    void close() throws IOException {
        server.close();
    }
}
