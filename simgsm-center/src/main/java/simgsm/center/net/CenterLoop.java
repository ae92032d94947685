package simgsm.center.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedSelectorException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.OptionalLong;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import simgsm.air.IpaFrame;
import simgsm.center.msc.Exchange;

/**
 * The thread that owns the exchange. It sleeps in the selector until octets, a posted task or the exchange's next
 * deadline wake it. Whatever a peer does ends at its own connection.
 */
public final class CenterLoop implements AutoCloseable {
    /** Further terminals are turned away at the door. */
    public static final int MAX_CONNECTIONS = 20_000;

    private static final System.Logger LOG = System.getLogger(CenterLoop.class.getName());
    private static final int READ_BUFFER_OCTETS = 64 * 1024;
    private static final int BACKLOG = 1_024;
    private static final long NANOS_PER_MILLI = 1_000_000;
    /** A pause before accepting again when the process may open no more files. */
    private static final long ACCEPT_PAUSE_NANOS = 500 * NANOS_PER_MILLI;

    private final Selector selector;
    private final ServerSocketChannel server;
    private final SelectionKey serverKey;
    private final Queue<Consumer<Exchange>> mailbox = new ConcurrentLinkedQueue<>();
    private final ArrayDeque<Broken> brokenConnections = new ArrayDeque<>();
    private final ByteBuffer readBuffer = ByteBuffer.allocateDirect(READ_BUFFER_OCTETS);
    private final long startNanos = System.nanoTime();
    private final Connection.Host host = new Host();
    private final Thread thread = new Thread(this::run, "centre");
    private Exchange exchange;
    private Runnable onFailure = () -> {};
    private final View view = new View();
    private int connections;
    private long acceptAgainNanos = Long.MAX_VALUE;
    private volatile boolean isClosing;

    private record Broken(Connection connection, String reason) {}

    private final class Host implements Connection.Host {
        @Override
        public void frameArrived(Connection connection, IpaFrame frame) {
            exchange.frameReceived(nowNanos(), connection.link, frame);
        }

        @Override
        public void broken(Connection connection, String reason) {
            brokenConnections.add(new Broken(connection, reason));
        }

        @Override
        public void closed(Connection connection) {
            connections--;
        }
    }

    private CenterLoop(InetSocketAddress address) throws IOException {
        selector = Selector.open();
        server = ServerSocketChannel.open();
        try {
            server.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            server.bind(address, BACKLOG);
            server.configureBlocking(false);
            serverKey = server.register(selector, SelectionKey.OP_ACCEPT);
        } catch (IOException e) {
            server.close();
            selector.close();
            throw e;
        }
    }

    /**
     * Opens the port; nothing is accepted before {@link #start}.
     *
     * @param port 0 for any free one
     * @throws IOException naming address and port
     */
    public static CenterLoop open(InetAddress address, int port) throws IOException {
        try {
            return new CenterLoop(new InetSocketAddress(address, port));
        } catch (IOException e) {
            throw new IOException(
                    "cannot listen on " + address.getHostAddress() + " port " + port + ": " + e.getMessage(), e);
        }
    }

    public int port() {
        return server.socket().getLocalPort();
    }

    /**
     * Gives the loop its exchange and begins.
     *
     * @param failed done when the thread has ended without being told to: the centre serves nobody any more
     */
    public void start(Exchange owned, Runnable failed) {
        exchange = owned;
        onFailure = failed;
        thread.start();
    }

    /**
     * Has the exchange looked at on the loop's thread after it has changed, but not more often than once a period. To be
     * set before {@link #start}.
     */
    public void watch(long periodNanos, Consumer<Exchange> look) {
        view.watch(periodNanos, look);
    }

    /** Has a task done by the thread that owns the exchange. Any thread may call this, that one too. */
    public void post(Consumer<Exchange> task) {
        mailbox.add(task);
        if (Thread.currentThread() != thread) {
            selector.wakeup();
        }
    }

    /** Nanoseconds since this loop was made: the exchange's time. */
    public long nowNanos() {
        return System.nanoTime() - startNanos;
    }

    private void run() {
        try {
            while (!isClosing) {
                round();
            }
        } catch (IOException | ClosedSelectorException e) {
            LOG.log(Level.ERROR, "the selector has failed: {0}", e.getMessage());
        } finally {
            shutAll();
            if (!isClosing) {
                onFailure.run();
            }
        }
    }

    private void round() throws IOException {
        selector.select(this::ready, millisToWait());
        advance();
        for (Consumer<Exchange> task = mailbox.poll(); task != null; task = mailbox.poll()) {
            Consumer<Exchange> next = task;
            view.changed();
            guarded("a posted task", () -> next.accept(exchange));
        }
        closeBroken();
        acceptAgain();
        guarded("the view", () -> view.lookIfDue(nowNanos(), exchange));
    }

    private void advance() {
        long now = nowNanos();
        if (exchange.nextDeadlineNanos().orElse(Long.MAX_VALUE) <= now) {
            view.changed();
            guarded("timers", () -> exchange.advance(now));
        }
    }

    /** At least 1 where something is due later, since 0 would mean "for ever". */
    private long millisToWait() {
        if (!mailbox.isEmpty()) {
            return 1;
        }
        long now = nowNanos();
        OptionalLong deadline = exchange.nextDeadlineNanos();
        long next = Math.min(deadline.orElse(Long.MAX_VALUE), Math.min(acceptAgainNanos, view.dueNanos()));
        return next == Long.MAX_VALUE ? 0 : Math.max(1, (next - now + NANOS_PER_MILLI - 1) / NANOS_PER_MILLI);
    }

    private void ready(SelectionKey key) {
        view.changed();
        if (key == serverKey) {
            accept();
        } else if (key.attachment() instanceof Connection connection && connection.isOpen()) {
            try {
                serve(connection, key);
            } catch (RuntimeException e) {
                LOG.log(Level.ERROR, connection.link + ": given up after an error of our own", e);
                host.broken(connection, "internal error");
            }
        }
        closeBroken();
    }

    private void serve(Connection connection, SelectionKey key) {
        if (key.isReadable()) {
            connection.readable(readBuffer);
        }
        if (key.isValid() && key.isWritable()) {
            connection.writable();
        }
    }

    private void accept() {
        try {
            for (SocketChannel channel = server.accept(); channel != null; channel = server.accept()) {
                if (connections >= MAX_CONNECTIONS) {
                    LOG.log(Level.WARNING, "{0}: turned away, {1} connections are open", channel, connections);
                    channel.close();
                } else {
                    welcome(channel);
                }
            }
        } catch (IOException e) {
            LOG.log(Level.WARNING, "cannot accept: {0}; trying again soon", e.getMessage());
            serverKey.interestOps(0);
            acceptAgainNanos = nowNanos() + ACCEPT_PAUSE_NANOS;
        }
    }

    private void acceptAgain() {
        if (nowNanos() >= acceptAgainNanos) {
            acceptAgainNanos = Long.MAX_VALUE;
            serverKey.interestOps(SelectionKey.OP_ACCEPT);
        }
    }

    private void welcome(SocketChannel channel) throws IOException {
        try {
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            InetSocketAddress peer = (InetSocketAddress) channel.getRemoteAddress();
            SelectionKey key = channel.register(selector, SelectionKey.OP_READ);
            Connection connection = new Connection(channel, key, host);
            key.attach(connection);
            connections++;
            connection.link = exchange.linkOpened(
                    nowNanos(), connection, peer.getAddress().getHostAddress() + ":" + peer.getPort());
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "a peer left before it was welcomed: {0}", e.getMessage());
            channel.close();
        }
    }

    private void closeBroken() {
        for (Broken broken = brokenConnections.poll(); broken != null; broken = brokenConnections.poll()) {
            if (broken.connection.isOpen()) {
                Broken gone = broken;
                gone.connection.shut();
                guarded("a closed link", () -> exchange.linkClosed(nowNanos(), gone.connection.link, gone.reason));
            }
        }
    }

    /** The last line of defence: a fault of ours is logged and does not end the centre. */
    private static void guarded(String what, Runnable action) {
        try {
            action.run();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "an error of our own in " + what, e);
        }
    }

    private void shutAll() {
        if (!selector.isOpen()) {
            return;
        }
        for (SelectionKey key : selector.keys()) {
            if (key.attachment() instanceof Connection connection) {
                connection.shut();
            }
        }
        try {
            server.close();
            selector.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing: {0}", e.getMessage());
        }
    }

    /** Closes the port and every connection, and waits for the thread to end. */
    @Override
    public void close() {
        isClosing = true;
        selector.wakeup();
        if (!thread.isAlive()) {
            shutAll();
            return;
        }
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
