package simgsm.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.StandardSocketOptions;
import java.nio.channels.SelectionKey;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;

/** A listening port of a {@link SelectorLoop}; connections beyond its limits are closed at once. */
public final class Acceptor implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Acceptor.class.getName());
    private static final int BACKLOG = 1_024;
    /** The rest of the backlog is accepted in the next iteration, after the open connections have been served. */
    private static final int ACCEPTS_PER_ITERATION = 64;

    /** One refusal in 1 000 is logged as a warning, to limit the log. */
    private static final int REFUSALS_PER_WARNING = 1_000;
    /** Pause after a failed accept, for instance without a free file descriptor. */
    private static final long RETRY_NANOS = 500_000_000;

    /** Makes the connection of an accepted socket. */
    public interface Factory {
        Connection connection(Connection.Endpoint endpoint);
    }

    private final SelectorLoop loop;
    private final ServerSocketChannel server;
    private final SelectionKey key;
    private final ConnectionLimits limits;
    private final Factory factory;
    private long refusals;

    Acceptor(SelectorLoop loop, InetSocketAddress address, ConnectionLimits limits, Factory factory)
            throws IOException {
        this.loop = loop;
        this.limits = limits;
        this.factory = factory;
        server = ServerSocketChannel.open();
        try {
            server.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            server.bind(address, BACKLOG);
            server.configureBlocking(false);
            key = server.register(loop.selector(), SelectionKey.OP_ACCEPT, (Runnable) this::accept);
        } catch (IOException e) {
            server.close();
            throw new IOException(
                    "cannot listen on " + address.getAddress().getHostAddress() + " port " + address.getPort() + ": "
                            + (isOwn(address.getAddress()) ? e.getMessage() : "not an address of this machine"),
                    e);
        }
    }

    private static boolean isOwn(InetAddress address) {
        try {
            return address.isAnyLocalAddress()
                    || address.isLoopbackAddress()
                    || NetworkInterface.getByInetAddress(address) != null;
        } catch (SocketException e) {
            return true; // The interfaces are not known, and the system's own words stand.
        }
    }

    public int port() {
        return server.socket().getLocalPort();
    }

    private void accept() {
        try {
            SocketChannel channel = server.accept();
            for (int count = 1; channel != null; count++) {
                accept(channel);
                channel = count < ACCEPTS_PER_ITERATION ? server.accept() : null;
            }
        } catch (IOException e) {
            LOG.log(
                    Level.WARNING,
                    "cannot accept on port {0}: {1}; next attempt in 0.5 s",
                    text(port()),
                    e.getMessage());
            key.interestOps(0);
            loop.after(RETRY_NANOS, this::resume);
        }
    }

    private void resume() {
        if (key.isValid()) {
            key.interestOps(SelectionKey.OP_ACCEPT);
        }
    }

    private void accept(SocketChannel channel) {
        try {
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            InetSocketAddress address = (InetSocketAddress) channel.getRemoteAddress();
            SelectionKey channelKey = channel.register(loop.selector(), 0);
            if (limits.admit(address.getAddress())) {
                open(new Connection.Endpoint(
                        loop, channel, channelKey, address, () -> limits.release(address.getAddress())));
            } else {
                refuse(channel, address);
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a peer left before it was accepted: {0}", e.getMessage());
            Connection.closeChannel(channel);
        }
    }

    private void open(Connection.Endpoint endpoint) {
        try {
            factory.connection(endpoint).open();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "a connection is not taken after an internal error", e);
            Connection.closeChannel(endpoint.channel());
            endpoint.whenClosed().run();
        }
    }

    private void refuse(SocketChannel channel, InetSocketAddress address) {
        refusals++;
        LOG.log(
                refusals % REFUSALS_PER_WARNING == 1 ? Level.WARNING : Level.DEBUG,
                "{0}: refused, {1} connections are open; refusal {2} on port {3}",
                address,
                limits.open(),
                refusals,
                text(port()));
        Connection.dismiss(channel);
    }

    private static String text(int number) {
        return Integer.toString(number);
    }

    /** Closes the port; its connections stay open. */
    @Override
    public void close() {
        try {
            server.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a port: {0}", e.getMessage());
        }
    }
}
