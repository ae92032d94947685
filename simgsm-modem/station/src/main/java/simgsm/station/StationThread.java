package simgsm.station;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import simgsm.net.Acceptor;
import simgsm.net.ConnectionLimits;
import simgsm.net.Connector;
import simgsm.net.Datagrams;
import simgsm.net.SelectorLoop;

/**
 * The thread that owns one or many stations: it gives them their time and keeps each connected to its centre,
 * retrying with pauses that grow from 0.2 s to 5 s. Any thread may call its methods.
 */
public final class StationThread implements AutoCloseable {
    private final SelectorLoop loop;
    private final Consumer<Throwable> onFailure;
    private final Set<StationLink> links = new LinkedHashSet<>();
    private boolean isClosing;

    /**
     * A daemon thread that is not started and must be closed.
     *
     * @param onFailure called by this thread if it ends by an error, which stops its stations
     */
    public StationThread(String name, Consumer<Throwable> onFailure) {
        loop = new SelectorLoop(name);
        this.onFailure = onFailure;
    }

    /** Starts the thread. */
    public void start() {
        SelectorLoop.Core end = new SelectorLoop.Core() {
            @Override
            public void ended() {
                List.copyOf(links).forEach(link -> loop.perform(link::close));
            }
        };
        loop.start(end, onFailure);
    }

    /** Adds a station and keeps it connected; before or after {@link #start}. */
    public void add(MobileStation station, InetSocketAddress center) {
        execute(() -> links.add(new StationLink(loop, station, center)));
    }

    /**
     * Detaches a station, writes its last frames, for at most a second, and disconnects.
     *
     * @param gone runs on this thread after the last sign of the station, or at the thread's end
     */
    public void remove(MobileStation station, Runnable gone) {
        execute(() -> links.stream().filter(link -> link.station() == station).forEach(link -> depart(link, gone)));
    }

    /**
     * Queues an action of this thread, run at the stations' time. An exception is logged. Dropped after the close.
     */
    public void execute(Runnable action) {
        loop.post(() -> {
            advanceStations();
            action.run();
        });
    }

    /** Runs an action of this thread once, after this time. Dropped after the close. */
    public void after(long nanos, Runnable action) {
        loop.post(() -> loop.after(nanos, () -> {
            advanceStations();
            action.run();
        }));
    }

    /**
     * Runs a question on this thread and returns its answer, or throws its exception.
     *
     * @throws IllegalStateException if the thread has ended or does not answer within 5 s
     */
    public <T> T ask(Callable<T> question) {
        return loop.ask(() -> {
            advanceStations();
            return question.call();
        });
    }

    /**
     * Opens a port with connections owned by this thread, like the stations; see {@link SelectorLoop#listen}.
     *
     * @throws IOException naming address and port
     */
    public Acceptor listen(InetSocketAddress address, ConnectionLimits limits, Acceptor.Factory factory)
            throws IOException {
        return loop.listen(address, limits, factory);
    }

    /**
     * Opens a UDP socket owned by this thread; see {@link SelectorLoop#datagrams}.
     *
     * @throws IOException naming address and port
     */
    public Datagrams datagrams(InetSocketAddress local, BiConsumer<byte[], InetSocketAddress> received)
            throws IOException {
        return loop.datagrams(local, received);
    }

    /** An outgoing connection owned by this thread, which calls its methods. */
    public Connector connector(InetSocketAddress address, Connector.Listener listener) {
        return new Connector(loop, address, listener);
    }

    private void advanceStations() {
        long now = System.nanoTime();
        links.forEach(link -> loop.perform(() -> link.station().timePassed(now)));
    }

    private void depart(StationLink link, Runnable gone) {
        link.depart(() -> {
            links.remove(link);
            endIfDone();
            gone.run();
        });
    }

    private void endIfDone() {
        if (isClosing && links.isEmpty()) {
            loop.end();
        }
    }

    /** Detaches the stations, writes their last frames, for at most a second, and ends the thread. */
    @Override
    public void close() {
        execute(() -> {
            isClosing = true;
            links.forEach(link -> depart(link, () -> {}));
            endIfDone();
        });
        loop.join();
    }
}
