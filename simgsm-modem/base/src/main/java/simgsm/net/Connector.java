package simgsm.net;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.concurrent.TimeUnit;
import simgsm.timer.Timer;

/**
 * Keeps one outgoing connection of a {@link SelectorLoop}: connects at once, and again after each loss or failure with
 * pauses that grow from 0.2 s to 5 s. All methods belong to the loop's thread.
 */
public final class Connector {
    private static final long FIRST_PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
    private static final long LONGEST_PAUSE_NANOS = TimeUnit.SECONDS.toNanos(5);
    /** Minimum lifetime of a connection that resets the pause; a server that closes each one at once does not. */
    private static final long STEADY_NANOS = TimeUnit.SECONDS.toNanos(1);

    private static final long CONNECT_NANOS = TimeUnit.SECONDS.toNanos(5);

    /** Receives the reports of a connector. */
    public interface Listener {
        /** Makes the connection of a connected socket. */
        Connection connected(Connection.Endpoint endpoint);

        /** An attempt has failed; the next one is scheduled. */
        void failed(String reason);
    }

    private final SelectorLoop loop;
    private final InetSocketAddress address;
    private final Listener listener;
    private final RetryPause pause = new RetryPause(FIRST_PAUSE_NANOS, LONGEST_PAUSE_NANOS);
    private SocketChannel channel;
    private SelectionKey key;
    private Connection connection;
    /** Timer of the next attempt, or limit of the current one. */
    private Timer timer;

    private long connectedNanos;
    /** Length of the next pause. */
    private long leastPauseNanos;

    private boolean isClosed;

    /** @param address may be unresolved; its name is resolved at each attempt */
    public Connector(SelectorLoop loop, InetSocketAddress address, Listener listener) {
        this.loop = loop;
        this.address = address;
        this.listener = listener;
    }

    /** Makes the first attempt. */
    public void start() {
        try {
            channel = SocketChannel.open();
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            key = channel.register(loop.selector(), 0, (Runnable) this::finish);
            timer = loop.after(CONNECT_NANOS, () -> failed("no answer"));
            if (channel.connect(resolved())) {
                connected();
            } else {
                key.interestOps(SelectionKey.OP_CONNECT);
            }
        } catch (IOException | RuntimeException e) {
            failed(Connection.reason(e));
        }
    }

    private InetSocketAddress resolved() {
        return address.isUnresolved() ? new InetSocketAddress(address.getHostString(), address.getPort()) : address;
    }

    private void finish() {
        try {
            channel.finishConnect();
            connected();
        } catch (IOException e) {
            failed(Connection.reason(e));
        }
    }

    private void connected() {
        loop.cancel(timer);
        connectedNanos = System.nanoTime();
        connection = listener.connected(new Connection.Endpoint(loop, channel, key, resolved(), this::lost));
        connection.open();
    }

    private void lost() {
        if (System.nanoTime() - connectedNanos > STEADY_NANOS) {
            pause.reset();
        }
        connection = null;
        retry();
    }

    private void failed(String reason) {
        closeChannel();
        retry();
        listener.failed(reason);
    }

    private void retry() {
        loop.cancel(timer);
        if (!isClosed) {
            timer = loop.after(Math.max(pause.next(), leastPauseNanos), this::start);
            leastPauseNanos = 0;
        }
    }

    /** Delays the next attempt by at least this time; called while a connection is closing. */
    public void postpone(long nanos) {
        leastPauseNanos = nanos;
    }

    /** Closes the connection and stops attempts. */
    public void close() {
        isClosed = true;
        loop.cancel(timer);
        if (connection != null) {
            connection.close();
        } else {
            closeChannel();
        }
    }

    private void closeChannel() {
        if (channel != null) {
            Connection.closeChannel(channel);
        }
    }
}
