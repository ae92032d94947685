package simgsm.center;

import java.io.IOException;
import java.net.InetAddress;
import java.time.Instant;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeListener;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.net.CenterLoop;
import simgsm.center.smsc.MemoryStore;

/** A running centre: its data directory, its port, its thread. */
final class Center implements AutoCloseable {
    /** Ten pictures a second are enough for an eye. */
    private static final long SNAPSHOT_PERIOD_NANOS = 100_000_000;

    private final DataDirectory data;
    private final CenterLoop loop;
    private final AtomicReference<ExchangeSnapshot> snapshot = new AtomicReference<>();

    private Center(DataDirectory data, CenterLoop loop) {
        this.data = data;
        this.loop = loop;
    }

    /**
     * Takes the data directory and the port; {@link #start} then lets the terminals in.
     *
     * @throws IOException naming the directory or the port that is not to be had
     */
    static Center open(DataDirectory data, InetAddress address, int port) throws IOException {
        try {
            return new Center(data, CenterLoop.open(address, port));
        } catch (IOException e) {
            data.close();
            throw e;
        }
    }

    int port() {
        return loop.port();
    }

    void start(long seed, ExchangeListener listener) {
        MemoryStore store =
                new MemoryStore(ticket -> loop.post(exchange -> exchange.committed(loop.nowNanos(), ticket, true)));
        loop.start(new Exchange(
                new ExchangeSettings(ExchangeSettings.DEFAULT_NETWORK_NAME, seed, Instant.now()), store, listener));
    }

    /** Has the exchange asked something by its own thread, and waits for the answer or its exception. */
    <T> T ask(Function<Exchange, T> question) {
        CompletableFuture<T> answer = new CompletableFuture<>();
        loop.post(exchange -> {
            try {
                answer.complete(question.apply(exchange));
            } catch (RuntimeException e) {
                answer.completeExceptionally(e);
            }
        });
        try {
            return answer.join();
        } catch (CompletionException e) {
            throw e.getCause() instanceof RuntimeException cause ? cause : e;
        }
    }

    /** Sends a text to everybody attached; IllegalArgumentException says what is wrong with it. */
    void broadcast(int channel, String text) {
        ask(exchange -> exchange.broadcast(loop.nowNanos(), channel, text));
    }

    /** From now on {@link #snapshot} is kept fresh; without a window nobody pays for it. To be called before start. */
    void publishSnapshots() {
        loop.watch(SNAPSHOT_PERIOD_NANOS, exchange -> snapshot.set(exchange.snapshot()));
    }

    AtomicReference<ExchangeSnapshot> snapshot() {
        return snapshot;
    }

    @Override
    public void close() {
        loop.close();
        data.close();
    }
}
