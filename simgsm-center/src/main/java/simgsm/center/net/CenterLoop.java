package simgsm.center.net;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import simgsm.center.capture.Capture;
import simgsm.center.capture.WireTap;
import simgsm.center.msc.Exchange;
import simgsm.center.smpp.SmppServer;
import simgsm.net.Acceptor;
import simgsm.net.Connection;
import simgsm.net.ConnectionLimits;
import simgsm.net.LineAddress;
import simgsm.net.SelectorLoop;

/** The thread that owns the exchange, its ports and its connections. */
public final class CenterLoop implements AutoCloseable {
    /** Pause between two reads of the wall clock under load, and when idle. */
    private static final long LOOK_NANOS = 10_000_000;

    private static final long LATEST_LOOK_NANOS = 1_000_000_000;

    /** Reserves one place in ten for addresses with an earlier successful bind. */
    private static final int RESERVED_SHARE = 10;

    private final SelectorLoop loop = new SelectorLoop("centre");
    private final long startNanos = System.nanoTime();
    private final PortLimits limits;
    private final Acceptor terminals;
    private final RateLimitedObserver observer = new RateLimitedObserver();
    private Optional<Capture> capture = Optional.empty();
    private Exchange exchange;
    private long lookedNanos;

    private final class Driver implements SelectorLoop.Core {
        @Override
        public long nextDeadlineNanos() {
            long next = Math.min(exchange.nextDeadlineNanos().orElse(Long.MAX_VALUE), observer.dueNanos());
            return startNanos + Math.min(next, lookedNanos + LATEST_LOOK_NANOS);
        }

        @Override
        public void advance(long loopNanos) {
            long now = loopNanos - startNanos;
            lookAtClock(now);
            if (exchange.nextDeadlineNanos().orElse(Long.MAX_VALUE) <= now) {
                changing().advance(now);
            }
            observer.showIfDue(now, exchange);
        }
    }

    private CenterLoop(InetAddress address, int port, PortLimits limits) throws IOException {
        this.limits = limits;
        try {
            terminals = loop.listen(
                    new InetSocketAddress(address, port),
                    new ConnectionLimits(limits.terminals(), limits.terminalsPerAddress()),
                    endpoint -> new TerminalConnection(endpoint, this, tap(endpoint)));
        } catch (IOException e) {
            loop.close();
            throw e;
        }
    }

    /**
     * Opens the port for terminals; {@link #start} begins accepting connections.
     *
     * @param port 0 for any free one
     * @throws IOException naming address and port
     */
    public static CenterLoop open(InetAddress address, int port, PortLimits limits) throws IOException {
        return new CenterLoop(address, port, limits);
    }

    /**
     * Opens a second port, for SMPP. Called before {@link #start}.
     *
     * @return the port
     */
    public int openSmpp(InetAddress address, int port, SmppServer smpp) throws IOException {
        int most = limits.applications();
        ConnectionLimits places = new ConnectionLimits(most, limits.applicationsPerAddress(), most / RESERVED_SHARE);
        return loop.listen(
                        new InetSocketAddress(address, port),
                        places,
                        endpoint -> new SmppConnection(endpoint, this, smpp, places))
                .port();
    }

    /** Captures all frames between terminals and centre. Called before {@link #start}. */
    public void captureTo(Capture running) {
        capture = Optional.of(running);
    }

    private WireTap tap(Connection.Endpoint endpoint) {
        return capture.map(running -> running.conversation(endpoint.address(), (InetSocketAddress)
                        endpoint.channel().socket().getLocalSocketAddress()))
                .orElse(WireTap.NONE);
    }

    static String text(InetSocketAddress address) {
        return LineAddress.of(address).toString();
    }

    public int port() {
        return terminals.port();
    }

    /**
     * Starts the thread.
     *
     * @param owned used only by this thread from now on
     * @param onFailure called when an error has ended the thread and all service
     */
    public void start(Exchange owned, Consumer<Throwable> onFailure) {
        exchange = owned;
        loop.start(new Driver(), onFailure);
    }

    /**
     * Shows the exchange, on the loop's thread, after changes, at most once per period. Called before {@link #start}.
     */
    public void observe(long periodNanos, Consumer<Exchange> newObserver) {
        observer.set(periodNanos, newObserver);
    }

    /**
     * Queues a task of the thread that owns the exchange. Callable on any thread.
     *
     * @return false if the thread has ended; the task is not run then
     */
    public boolean post(Consumer<Exchange> task) {
        return loop.post(() -> task.accept(changing()));
    }

    /**
     * Runs a question on the thread that owns the exchange and returns its answer, or throws its exception. Callable on
     * any thread.
     *
     * @throws IllegalStateException if the thread has ended or does not answer within 5 s
     */
    public <T> T ask(Function<Exchange, T> question) {
        return loop.ask(() -> question.apply(changing()));
    }

    /** Nanoseconds since this loop's creation: the exchange's time. */
    public long nowNanos() {
        return System.nanoTime() - startNanos;
    }

    /** The exchange, for a call that may change it. */
    Exchange changing() {
        observer.changed();
        lookAtClock(nowNanos());
        return exchange;
    }

    private void lookAtClock(long nowNanos) {
        if (nowNanos - lookedNanos > LOOK_NANOS) {
            lookedNanos = nowNanos;
            exchange.clockShows(nowNanos, Instant.now());
        }
    }

    /** Closes the ports and every connection, and waits for the thread to end. */
    @Override
    public void close() {
        loop.close();
    }
}
