package simgsm.station;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/**
 * The one thread that gives one or many stations their time and their sockets. It connects each to its centre, at once and
 * then again with pauses that grow from 0.2 s to 5 s, and owns the stations until it is closed.
 */
public final class StationThread implements AutoCloseable {
    private static final System.Logger LOGGER = System.getLogger("simgsm.station");

    /** How long the farewell may take. */
    private static final long CLOSING_NANOS = TimeUnit.SECONDS.toNanos(1);

    /** Without any deadline the loop still looks around that often. */
    private static final long LONGEST_WAIT_NANOS = TimeUnit.SECONDS.toNanos(1);

    /** How often those who leave are looked after. */
    private static final long LEAVING_LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

    private static final int BUFFER_LENGTH = 65_536;

    private final Selector selector;
    private final Thread thread;
    private final Consumer<Throwable> failed;
    private final Queue<Runnable> acts = new ConcurrentLinkedQueue<>();
    private final List<StationLink> links = new ArrayList<>();
    private final List<Leaving> leaving = new ArrayList<>();
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER_LENGTH);
    private volatile long droppedSpeechFrames;
    private volatile boolean closing;

    /**
     * Not started yet. It is a daemon thread: whoever starts it closes it.
     *
     * @param failed told, by this thread, when it ends without having been closed: the stations are dead for good
     */
    public StationThread(String name, Consumer<Throwable> failed) {
        this.failed = failed;
        try {
            selector = Selector.open();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        thread = new Thread(this::run, name);
        thread.setDaemon(true);
    }

    /** Starts the thread. */
    public void start() {
        thread.start();
    }

    /** Takes over a station and keeps it connected. Any thread may call it, before or after {@link #start}. */
    public void add(MobileStation station, InetSocketAddress center) {
        execute(() -> links.add(new StationLink(station, center, System.nanoTime())));
    }

    /**
     * Detaches a station and lets it go, as soon as its farewell is written and after a second at the latest. Any thread
     * may call it.
     *
     * @param gone run by the owner thread when nothing more will come from the station, also when the thread ends first
     */
    public void remove(MobileStation station, Runnable gone) {
        execute(() -> {
            for (StationLink link : List.copyOf(links)) {
                if (link.station() == station) {
                    station.powerOff();
                    leaving.add(new Leaving(link, System.nanoTime() + CLOSING_NANOS, gone));
                }
            }
        });
    }

    /** A station on its way out. */
    private record Leaving(StationLink link, long endNanos, Runnable gone) {}

    private void letGo() {
        long now = System.nanoTime();
        for (Leaving one : List.copyOf(leaving)) {
            if (isDone(one.link()) || now - one.endNanos() >= 0) {
                leaving.remove(one);
                links.remove(one.link());
                one.link().close();
                guarded(one.gone());
            }
        }
    }

    /**
     * Has the act done by the owner thread, in order; the stations' time is now when it runs. Any thread may call it. An act
     * that throws is logged and the thread goes on. After the close it is dropped.
     */
    public void execute(Runnable act) {
        acts.add(act);
        if (Thread.currentThread() != thread) {
            selector.wakeup();
        }
    }

    /** Speech frames that were dropped because the centre did not take them within 200 ms. */
    public long droppedSpeechFrames() {
        return droppedSpeechFrames;
    }

    /** Detaches the stations, writes what is still to be written (for at most a second) and ends the thread. */
    @Override
    public void close() {
        closing = true;
        selector.wakeup();
        if (Thread.currentThread() == thread || !thread.isAlive()) {
            return;
        }
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void run() {
        try {
            while (!closing) {
                turn(System.nanoTime() + LONGEST_WAIT_NANOS);
            }
            sayFarewell();
        } catch (Throwable fault) {
            fail(fault);
        } finally {
            links.forEach(StationLink::close);
            leaving.forEach(one -> guarded(one.gone()));
            closeSelector();
        }
    }

    private void fail(Throwable fault) {
        if (closing) {
            LOGGER.log(Level.ERROR, "the stations'' loop ends in the middle of its farewell: {0}", fault.toString());
        } else {
            LOGGER.log(Level.DEBUG, "the stations' loop ends", fault);
            failed.accept(fault);
        }
    }

    /** Whoever has nothing to say farewell to is not waited for. */
    private void sayFarewell() throws IOException {
        long end = System.nanoTime() + CLOSING_NANOS;
        execute(() -> links.forEach(link -> link.station().powerOff()));
        perform(System.nanoTime());
        while (!links.stream().allMatch(StationThread::isDone) && System.nanoTime() < end) {
            turn(end);
        }
    }

    private static boolean isDone(StationLink link) {
        return link.isFlushed() && link.station().isDetached();
    }

    /** Acts, time, sockets; then waits for the next of these, but not beyond the end given. */
    private void turn(long endNanos) throws IOException {
        long now = System.nanoTime();
        perform(now);
        long next = endNanos;
        long dropped = 0;
        for (StationLink link : links) {
            guarded(() -> link.timePassed(selector, now));
            next = Math.min(next, link.nextDeadlineNanos());
            dropped += link.droppedSpeechFrames();
        }
        droppedSpeechFrames = dropped;
        if (!leaving.isEmpty()) {
            letGo();
            next = Math.min(next, now + LEAVING_LOOK_NANOS);
        }
        select(next);
    }

    private void perform(long now) {
        for (Runnable act = acts.poll(); act != null; act = acts.poll()) {
            links.forEach(link -> link.station().timePassed(now));
            guarded(act);
        }
    }

    private void select(long nextNanos) throws IOException {
        long waitMillis = TimeUnit.NANOSECONDS.toMillis(nextNanos - System.nanoTime() + 999_999);
        if (waitMillis > 0 && acts.isEmpty()) {
            selector.select(key -> ready((StationLink) key.attachment()), waitMillis);
        } else {
            selector.selectNow(key -> ready((StationLink) key.attachment()));
        }
    }

    private void ready(StationLink link) {
        guarded(() -> link.ready(buffer, System.nanoTime()));
    }

    /** A fault in one station must not take the others down; after an Error nothing can be relied upon. */
    private static void guarded(Runnable act) {
        try {
            act.run();
        } catch (RuntimeException e) {
            LOGGER.log(Level.ERROR, "an act failed: {0}", e.toString());
            LOGGER.log(Level.DEBUG, "where it failed", e);
        }
    }

    private void closeSelector() {
        try {
            selector.close();
        } catch (IOException e) {
            LOGGER.log(Level.DEBUG, "closing: {0}", e.getMessage());
        }
    }
}
