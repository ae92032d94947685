package simrobot.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger.Level;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import simgsm.console.Event;
import simgsm.thread.DaemonThread;
import simrobot.replay.RecordingFormat.StoredRecord;
import simrobot.simulation.Simulation;

/**
 * Records a session to a file in real time. The simulation's thread collects states and events; a separate thread
 * deflates and writes them, at least every 400 ms, so that a kill loses at most the last half second. The simulation
 * never waits for the disk: the recording ends if 512 records wait.
 */
public final class SessionRecorder implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(SessionRecorder.class.getName());
    private static final long FLUSH_MILLIS = 400;

    /** Maximum of records waiting for the disk, of about 64 KB each. */
    private static final int QUEUE_RECORDS = 512;

    private static final long CLOSE_SECONDS = 10;
    private static final Supplier<byte[]> END = () -> new byte[0];

    private final String name;
    private final OutputStream file;
    private final Executor simulationThread;
    private final SessionEncoder encoder;
    private final BlockingQueue<Supplier<byte[]>> queue = new ArrayBlockingQueue<>(QUEUE_RECORDS);
    private final AtomicBoolean flushRequested = new AtomicBoolean();
    private final Thread writer;
    private volatile IOException failure;
    private boolean closed;

    SessionRecorder(String name, OutputStream file, Simulation simulation, Executor simulationThread) {
        this.name = name;
        this.file = file;
        this.simulationThread = simulationThread;
        writer = DaemonThread.start("session recorder", this::write);
        encoder = new SessionEncoder(
                simulation,
                (kind, begin, end, content) ->
                        queue(() -> StoredRecord.of(kind, begin, end, content).octets()));
        simulation.addStepListener(this::step);
    }

    /**
     * Begins a recording of this simulation in its current state; an existing file is overwritten. Called by the
     * simulation's owner, or before it has one.
     *
     * @param simulationThread performs acts between two steps; it may drop them, then records are written when full
     * @throws IOException if the file cannot be written
     */
    public static SessionRecorder open(Path path, Simulation simulation, Executor simulationThread) throws IOException {
        try {
            OutputStream file = Files.newOutputStream(path);
            file.write(RecordingFormat.header());
            return new SessionRecorder(path.toString(), file, simulation, simulationThread);
        } catch (FileSystemException e) {
            throw e; // already names the file
        } catch (IOException e) {
            throw new IOException(path + ": " + e.getMessage(), e);
        }
    }

    /** Records an event of the console at the current simulated time; callable on any thread. */
    public synchronized void event(Event event) {
        if (!closed) {
            encoder.event(event);
        }
    }

    private synchronized void step(long timeNanos) {
        if (!closed && failure == null) {
            encoder.step(timeNanos);
        }
    }

    private synchronized void flush() {
        flushRequested.set(false);
        if (!closed && failure == null) {
            encoder.flush();
        }
    }

    private void queue(Supplier<byte[]> record) {
        if (failure == null && !queue.offer(record)) {
            fail(new IOException("the disk takes no more data"));
        }
    }

    private void write() throws InterruptedException {
        try (file) {
            while (true) {
                Supplier<byte[]> record = queue.poll(FLUSH_MILLIS, TimeUnit.MILLISECONDS);
                if (record == END || record == null && failure != null) {
                    return;
                } else if (record != null) {
                    file.write(record.get());
                } else if (flushRequested.compareAndSet(false, true)) {
                    simulationThread.execute(this::flush);
                }
            }
        } catch (IOException e) {
            fail(e);
        } catch (RuntimeException e) {
            fail(new IOException(e.toString(), e));
        }
    }

    private void fail(IOException why) {
        failure = why;
        LOG.log(Level.WARNING, "{0}: recording ends: {1}", name, why.getMessage());
    }

    /** The failure that ended the recording, such as a full disk; callable on any thread. */
    public Optional<IOException> failure() {
        return Optional.ofNullable(failure);
    }

    /**
     * Writes the rest, as {@link #close} does.
     *
     * @throws IOException naming the file, if a part of the session could not be written
     */
    public void finish() throws IOException {
        close();
        if (failure != null) {
            throw new IOException(name + ": " + failure.getMessage(), failure);
        }
    }

    /**
     * Writes the rest, unless the recording has failed; on the simulation's thread, or after its end. Safe to call
     * twice.
     */
    @Override
    public void close() {
        synchronized (this) {
            if (closed) {
                return;
            }
            if (failure == null) {
                encoder.end();
            }
            closed = true;
        }
        queue(END);
        if (failure != null) {
            return;
        }
        DaemonThread.join(writer, TimeUnit.SECONDS.toMillis(CLOSE_SECONDS));
    }
}
