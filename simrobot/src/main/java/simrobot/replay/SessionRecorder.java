package simrobot.replay;

import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger.Level;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import simgsm.console.Event;
import simrobot.simulation.Simulation;

/**
 * Records a session in a file while it happens. A thread of its own writes; what happened more than half a second ago is
 * in the file whatever becomes of the program. Only a disk that does not keep up with the simulation slows it down.
 */
public final class SessionRecorder implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(SessionRecorder.class.getName());
    private static final long FLUSH_MILLIS = 400;
    private static final int QUEUE_RECORDS = 64;
    private static final long PATIENCE_SECONDS = 10;
    private static final byte[] END = {};

    private final Path path;
    private final OutputStream file;
    private final Executor simulationThread;
    private final SessionEncoder encoder;
    private final BlockingQueue<byte[]> queue = new ArrayBlockingQueue<>(QUEUE_RECORDS);
    private final AtomicBoolean flushAsked = new AtomicBoolean();
    private final Thread writer;
    private volatile boolean failed;
    private boolean closed;

    private SessionRecorder(Path path, OutputStream file, Simulation simulation, Executor simulationThread) {
        this.path = path;
        this.file = file;
        this.simulationThread = simulationThread;
        writer = new Thread(this::write, "session recorder");
        writer.setDaemon(true);
        writer.start();
        encoder = new SessionEncoder(simulation, (kind, content) -> queue(RecordCodec.encode(kind, content)));
        simulation.addStepListener(this::step);
    }

    /**
     * Begins a recording of this simulation as it is now; what the file held before is gone. To be called by the
     * simulation's owner, or before it has one.
     *
     * @param simulationThread runs acts between two steps; where nobody does, acts may be dropped
     * @throws IOException if the file cannot be written
     */
    public static SessionRecorder open(Path path, Simulation simulation, Executor simulationThread) throws IOException {
        try {
            OutputStream file = Files.newOutputStream(path);
            file.write(RecordCodec.header());
            return new SessionRecorder(path, file, simulation, simulationThread);
        } catch (FileSystemException e) {
            throw e; // Names the file already.
        } catch (IOException e) {
            throw new IOException(path + ": " + e.getMessage(), e);
        }
    }

    /** Something has been told on the console, or would be if there were one; any thread may tell. */
    public synchronized void event(Event event) {
        if (!closed) {
            encoder.event(event);
        }
    }

    private synchronized void step(long timeNanos) {
        if (!closed && !failed) {
            encoder.step(timeNanos);
        }
    }

    private synchronized void flush() {
        flushAsked.set(false);
        if (!closed && !failed) {
            encoder.flush();
        }
    }

    private void queue(byte[] octets) {
        try {
            if (!failed && !queue.offer(octets, PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                fail("the disk takes nothing any more");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            fail("interrupted");
        }
    }

    private void write() {
        try (file) {
            while (true) {
                byte[] octets = queue.poll(FLUSH_MILLIS, TimeUnit.MILLISECONDS);
                if (octets == END) {
                    return;
                } else if (octets != null) {
                    file.write(octets);
                } else if (flushAsked.compareAndSet(false, true)) {
                    simulationThread.execute(this::flush);
                }
            }
        } catch (IOException e) {
            fail(e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void fail(String why) {
        failed = true;
        LOG.log(Level.WARNING, "{0}: recording ends: {1}", path, why);
    }

    /** Writes what is still to be written; the simulation's thread has ended, or calls it. More than once does no harm. */
    @Override
    public void close() {
        synchronized (this) {
            if (closed) {
                return;
            }
            if (!failed) {
                encoder.end();
            }
            closed = true;
        }
        queue(END);
        try {
            writer.join(TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
