package simrobot.pioneer;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.AsynchronousCloseException;
import java.nio.channels.ByteChannel;
import java.nio.channels.UnresolvedAddressException;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import simgsm.net.LineAddress;
import simgsm.net.RetryPause;
import simgsm.thread.DaemonThread;

/**
 * Connection and clock of a {@link RealPioneer}. Serial lines block, so one thread connects and reads, one writes, and
 * one posts a tick every 100 ms; {@link #close} ends all three. The robot's core runs on the simulation's thread. A
 * failed connection is retried after pauses that grow from 0.5 s to 15 s.
 */
public final class PioneerCall implements PioneerLine, AutoCloseable {
    private static final Logger LOG = System.getLogger(PioneerCall.class.getName());
    private static final long FIRST_PAUSE_MILLIS = 500;
    private static final long LONGEST_PAUSE_MILLIS = 15_000;
    private static final long TICK_MILLIS = 100;
    private static final long GOODBYE_MILLIS = 1000;
    private static final int MOST_QUEUED = 256;
    private static final int CHUNK = 1024;
    /** Queue marker: closes the connection after the preceding packets. */
    private static final byte[] END = {};

    private final String robot;
    private final LineAddress address;
    private final Executor simulation;
    private final BlockingQueue<byte[]> outgoing = new ArrayBlockingQueue<>(MOST_QUEUED);
    private final AtomicBoolean tickPosted = new AtomicBoolean();
    /** Guards the fields from {@link #wanted} to {@link #pause}. */
    private final Object lock = new Object();

    private boolean wanted;
    private boolean closed;
    private boolean retriesNow;
    private final RetryPause pause = new RetryPause(FIRST_PAUSE_MILLIS, LONGEST_PAUSE_MILLIS);

    private RealPioneer pioneer;
    private Thread reader;
    private volatile ByteChannel channel;

    /** @param simulation runs actions on the thread that owns the robot, in their order */
    public PioneerCall(String robot, LineAddress address, Executor simulation) {
        this.robot = robot;
        this.address = address;
        this.simulation = simulation;
    }

    /** Starts the threads; {@link #call} connects. */
    public void start(RealPioneer served) {
        pioneer = served;
        reader = thread("reader", this::keepConnected);
        thread("writer", this::write);
        thread("time", this::keepTime);
    }

    private Thread thread(String what, DaemonThread.Work work) {
        return DaemonThread.start("pioneer " + robot + " " + what, work);
    }

    // ---- from the core, on the simulation's thread ---------------------------------------------------------------

    @Override
    public void send(byte[] packet) {
        if (!outgoing.offer(packet)) {
            drop();
        }
    }

    @Override
    public void call() {
        synchronized (lock) {
            wanted = true;
            retriesNow = true;
            pause.reset();
            lock.notifyAll();
        }
    }

    /** Drops the connection; queued packets may be lost. */
    @Override
    public void drop() {
        ByteChannel open = channel;
        if (open != null) {
            try {
                open.close();
            } catch (IOException e) {
                LOG.log(Level.DEBUG, "closing failed", e);
            }
        }
    }

    @Override
    public void hangUp() {
        synchronized (lock) {
            wanted = false;
        }
        if (!outgoing.offer(END)) {
            drop();
        }
    }

    /** Stops the robot and ends the threads, as {@link #close} does, without waiting for them. */
    public void end() {
        thread("end", this::close);
    }

    /** Stops the robot, ends the connection and the threads, and waits at most 1 s for that. */
    @Override
    public void close() {
        simulation.execute(() -> pioneer.setPower(false));
        synchronized (lock) {
            closed = true;
            lock.notifyAll();
        }
        DaemonThread.join(reader, GOODBYE_MILLIS);
        drop();
    }

    // ---- the threads ---------------------------------------------------------------------------------------------

    private void keepConnected() throws InterruptedException {
        while (awaitWanted()) {
            try (ByteChannel open = address.open()) {
                outgoing.clear();
                channel = open;
                if (isWanted()) {
                    simulation.execute(() -> pioneer.connected(System.nanoTime()));
                    read(open);
                    LOG.log(Level.INFO, robot + ": the Pioneer at " + address + " has ended the connection");
                }
            } catch (AsynchronousCloseException e) {
                LOG.log(Level.INFO, robot + ": the connection to the Pioneer at " + address + " is closed");
            } catch (IOException | UnresolvedAddressException e) {
                LOG.log(Level.WARNING, robot + ": no Pioneer at " + address + " (" + e.getMessage() + ")");
            }
            channel = null;
            simulation.execute(pioneer::disconnected);
            pause();
        }
    }

    private boolean isWanted() {
        synchronized (lock) {
            return wanted && !closed;
        }
    }

    /** @return false once closed */
    private boolean awaitWanted() throws InterruptedException {
        synchronized (lock) {
            while (!wanted && !closed) {
                lock.wait();
            }
            return !closed;
        }
    }

    /** Ended by {@link #call} and {@link #close}. */
    private void pause() throws InterruptedException {
        synchronized (lock) {
            retriesNow = false;
            long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(pause.next());
            for (long left = 1; left > 0 && !closed && !retriesNow; ) {
                left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
                lock.wait(Math.max(1, left));
            }
        }
    }

    private void read(ByteChannel open) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(CHUNK);
        while (open.read(buffer) >= 0) {
            if (buffer.position() > 0) {
                byte[] octets = new byte[buffer.flip().remaining()];
                buffer.get(octets);
                buffer.clear();
                simulation.execute(() -> pioneer.received(octets, System.nanoTime()));
                synchronized (lock) {
                    pause.reset();
                }
            }
        }
    }

    private void write() throws InterruptedException {
        while (reader.isAlive()) {
            byte[] packet = outgoing.poll(TICK_MILLIS, TimeUnit.MILLISECONDS);
            ByteChannel open = channel;
            if (packet == END) {
                drop();
            } else if (packet != null && open != null) {
                write(open, packet);
            }
        }
    }

    private void write(ByteChannel open, byte[] packet) {
        try {
            ByteBuffer rest = ByteBuffer.wrap(packet);
            while (rest.hasRemaining()) {
                open.write(rest);
            }
        } catch (IOException e) {
            drop();
        }
    }

    private void keepTime() throws InterruptedException {
        while (reader.isAlive()) {
            reader.join(TICK_MILLIS);
            if (tickPosted.compareAndSet(false, true)) {
                simulation.execute(() -> {
                    tickPosted.set(false);
                    pioneer.tick(System.nanoTime());
                });
            }
        }
    }
}
