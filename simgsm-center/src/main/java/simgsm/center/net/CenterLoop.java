package simgsm.center.net;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.center.capture.Capture;
import simgsm.center.capture.WireTap;
import simgsm.center.msc.Exchange;

/**
 * The thread that owns the exchange. It sleeps in the selector until octets, a posted task or the exchange's next
 * deadline wake it. Whatever a peer does ends at its own connection.
 */
public final class CenterLoop implements AutoCloseable {
    /** Further terminals are turned away at the door. */
    public static final int MAX_CONNECTIONS = 20_000;
    /** So are further ones of one address beyond this machine: a class behind one router, not a flood. */
    static final int MAX_CONNECTIONS_PER_ADDRESS = 500;
    /** So are further applications. */
    public static final int MAX_APPLICATIONS = 5_000;
    /** Of one gateway, with all its sessions. */
    static final int MAX_APPLICATIONS_PER_ADDRESS = 2_000;

    private static final System.Logger LOG = System.getLogger(CenterLoop.class.getName());
    private static final int READ_BUFFER_OCTETS = 64 * 1024;
    private static final long NANOS_PER_MILLI = 1_000_000;

    private final Selector selector;
    private final Acceptor terminals;
    private Acceptor applications;
    private Optional<Capture> capture = Optional.empty();
    private final Queue<Consumer<Exchange>> mailbox = new ConcurrentLinkedQueue<>();
    private final ArrayDeque<Broken> brokenConnections = new ArrayDeque<>();
    private final ByteBuffer readBuffer = ByteBuffer.allocateDirect(READ_BUFFER_OCTETS);
    private final long startNanos = System.nanoTime();
    private final Host host = new Host();
    private final ArrayDeque<SmppConnection> unsent = new ArrayDeque<>();
    private final FairReadQueue turns = new FairReadQueue();
    private final AtomicBoolean isWoken = new AtomicBoolean();
    private final Thread thread = new Thread(this::run, "centre");
    private Exchange exchange;
    private Consumer<Throwable> onFailure = cause -> {};
    private final View view = new View();
    private volatile boolean isClosing;

    private record Broken(Peer peer, String reason) {}

    private final class Host implements Connection.Host, SmppConnection.Server {
        @Override
        public void frameArrived(Connection connection, IpaFrame frame) {
            exchange.frameReceived(nowNanos(), connection.link, frame);
        }

        @Override
        public void lost(Connection connection, String reason) {
            exchange.linkClosed(nowNanos(), connection.link, reason);
        }

        @Override
        public void received(SmppConnection connection, ByteBuffer octets) {
            exchange.perform(nowNanos(), () -> exchange.smpp().received(connection.session, octets));
        }

        @Override
        public void lost(SmppConnection connection, String reason) {
            exchange.perform(nowNanos(), () -> exchange.smpp().closed(connection.session, reason));
        }

        @Override
        public void hasUnsent(SmppConnection connection) {
            unsent.add(connection);
        }

        @Override
        public void broken(Peer peer, String reason) {
            brokenConnections.add(new Broken(peer, reason));
        }

        @Override
        public void closed(Peer peer) {
            (peer instanceof SmppConnection ? applications : terminals).left(peer);
        }

        @Override
        public long nowNanos() {
            return CenterLoop.this.nowNanos();
        }

        @Override
        public void awaitsTurn(Connection connection, RateLimitedFrameReader.Rest rest) {
            turns.add(connection, rest, nowNanos());
        }
    }

    private CenterLoop(InetAddress address, int port) throws IOException {
        selector = Selector.open();
        try {
            terminals = Acceptor.open(
                    selector,
                    address,
                    port,
                    new ConnectionLimits(MAX_CONNECTIONS, MAX_CONNECTIONS_PER_ADDRESS),
                    this::terminal);
        } catch (IOException e) {
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
        return new CenterLoop(address, port);
    }

    /**
     * Opens a second port, for SMPP. To be called before {@link #start}.
     *
     * @return the port
     */
    public int openSmpp(InetAddress address, int port) throws IOException {
        applications = Acceptor.open(
                selector,
                address,
                port,
                new ConnectionLimits(MAX_APPLICATIONS, MAX_APPLICATIONS_PER_ADDRESS),
                this::application);
        return applications.port();
    }

    /** Has everything that terminals and centre say to each other written down. To be called before {@link #start}. */
    public void captureTo(Capture running) {
        capture = Optional.of(running);
    }

    private Peer terminal(Peer.Incoming incoming) {
        Connection connection = new Connection(incoming, host, tap(incoming.channel(), incoming.address()));
        return welcomed(
                connection,
                () -> connection.link =
                        exchange.linkOpened(nowNanos(), connection, text(incoming.address()), isLocal(incoming)));
    }

    private static boolean isLocal(Peer.Incoming incoming) {
        return incoming.address().getAddress().isLoopbackAddress();
    }

    private WireTap tap(SocketChannel channel, InetSocketAddress peer) {
        return capture.map(running -> running.conversation(
                        peer, (InetSocketAddress) channel.socket().getLocalSocketAddress()))
                .orElse(WireTap.NONE);
    }

    private Peer application(Peer.Incoming incoming) {
        SmppConnection connection = new SmppConnection(incoming, host);
        return welcomed(
                connection,
                () -> exchange.perform(
                        nowNanos(),
                        () -> connection.session =
                                exchange.smpp().opened(connection, text(incoming.address()), isLocal(incoming))));
    }

    /** An error of our own while a peer is introduced to the exchange costs that peer alone. */
    private static Peer welcomed(Peer peer, Runnable introduction) {
        try {
            introduction.run();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "a connection is not taken after an error of our own", e);
            peer.shut();
        }
        return peer;
    }

    private static String text(InetSocketAddress address) {
        return address.getAddress().getHostAddress() + ":" + address.getPort();
    }

    public int port() {
        return terminals.port();
    }

    /**
     * Gives the loop its exchange and begins.
     *
     * @param failed told when the thread has ended without being told to: the centre serves nobody any more
     */
    public void start(Exchange owned, Consumer<Throwable> failed) {
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
        if (Thread.currentThread() != thread && isWoken.compareAndSet(false, true)) {
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
        } catch (Throwable fault) {
            fail(fault);
        } finally {
            shutAll();
        }
    }

    private void fail(Throwable fault) {
        LOG.log(Level.DEBUG, "the loop ends", fault);
        if (!isClosing) {
            onFailure.accept(fault);
        }
    }

    private void round() throws IOException {
        select();
        advance();
        takeTurns();
        isWoken.set(false);
        for (Consumer<Exchange> task = mailbox.poll(); task != null; task = mailbox.poll()) {
            Consumer<Exchange> next = task;
            view.changed();
            guarded("a posted task", () -> next.accept(exchange));
        }
        do {
            flush();
            closeBroken();
        } while (!unsent.isEmpty());
        terminals.acceptAgain(nowNanos());
        if (applications != null) {
            applications.acceptAgain(nowNanos());
        }
        guarded("the view", () -> view.lookIfDue(nowNanos(), exchange));
    }

    private void select() throws IOException {
        if (turns.dueNanos() <= nowNanos()) {
            selector.selectNow(this::ready);
        } else {
            selector.select(this::ready, millisToWait());
        }
    }

    /** Those who had more than a portion go on, once each, now that all others have been served. */
    private void takeTurns() {
        long now = nowNanos();
        for (int left = turns.size(); left > 0; left--) {
            Connection connection = turns.next(now);
            if (connection == null) {
                return;
            }
            view.changed();
            faultless(connection, connection::turn);
            closeBroken();
        }
    }

    /** An error of our own costs the connection that met it. */
    private void faultless(Peer peer, Runnable action) {
        try {
            action.run();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, "a connection is given up after an error of our own", e);
            host.broken(peer, "internal error");
        }
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
        long next = Math.min(
                Math.min(deadline.orElse(Long.MAX_VALUE), turns.dueNanos()),
                Math.min(acceptAgainNanos(), view.dueNanos()));
        return next == Long.MAX_VALUE ? 0 : Math.max(1, (next - now + NANOS_PER_MILLI - 1) / NANOS_PER_MILLI);
    }

    private long acceptAgainNanos() {
        long later = applications == null ? Long.MAX_VALUE : applications.acceptAgainNanos();
        return Math.min(terminals.acceptAgainNanos(), later);
    }

    /** What a turn has brought to an application goes out together. */
    private void flush() {
        for (SmppConnection each = unsent.poll(); each != null; each = unsent.poll()) {
            each.endTurn();
        }
    }

    private void ready(SelectionKey key) {
        view.changed();
        if (key.attachment() instanceof Acceptor door) {
            guarded("accepting", () -> door.accept(nowNanos()));
        } else if (key.attachment() instanceof Peer peer && peer.isOpen()) {
            faultless(peer, () -> serve(peer, key));
        }
        closeBroken();
    }

    private void serve(Peer peer, SelectionKey key) {
        if (key.isReadable()) {
            peer.readable(readBuffer);
        }
        if (key.isValid() && key.isWritable()) {
            peer.writable();
        }
    }

    private void closeBroken() {
        for (Broken broken = brokenConnections.poll(); broken != null; broken = brokenConnections.poll()) {
            if (broken.peer.isOpen()) {
                Broken gone = broken;
                gone.peer.shut();
                guarded("a closed link", () -> gone.peer.lost(gone.reason));
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
            if (key.attachment() instanceof Peer peer) {
                peer.shut();
            }
        }
        try {
            terminals.close();
            if (applications != null) {
                applications.close();
            }
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
