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

/**
 * Gives a {@link RealPioneer} its line and its time: one thread connects and reads, one writes, one keeps time; what comes
 * is done on the simulation's thread. A connection that is lost, or never was, is tried again after growing pauses.
 */
public final class PioneerCall implements PioneerLine, AutoCloseable {
    private static final Logger LOG = System.getLogger(PioneerCall.class.getName());
    private static final long FIRST_PAUSE_MILLIS = 500;
    private static final long LONGEST_PAUSE_MILLIS = 15_000;
    private static final long TICK_MILLIS = 100;
    private static final long GOODBYE_MILLIS = 1000;
    private static final int MOST_QUEUED = 256;
    private static final int CHUNK = 1024;

    private final String robot;
    private final PioneerAddress address;
    private final Executor simulation;
    private final BlockingQueue<byte[]> outgoing = new ArrayBlockingQueue<>(MOST_QUEUED);
    private final AtomicBoolean tickPosted = new AtomicBoolean();
    private final Object wish = new Object();
    private RealPioneer pioneer;
    private Thread liner;
    private boolean wanted;
    private boolean closed;
    private long pauseMillis = FIRST_PAUSE_MILLIS;
    private volatile ByteChannel channel;

    /** @param simulation runs acts on the thread that owns the robot, in their order */
    public PioneerCall(String robot, PioneerAddress address, Executor simulation) {
        this.robot = robot;
        this.address = address;
        this.simulation = simulation;
    }

    /** The robot whose line this is; it is called when it wants to. */
    public void start(RealPioneer served) {
        pioneer = served;
        liner = thread("line", this::keepConnected);
        thread("sender", this::write);
        thread("time", this::keepTime);
    }

    private Thread thread(String what, Runnable work) {
        Thread thread = new Thread(work, "pioneer " + robot + " " + what);
        thread.setDaemon(true);
        thread.start();
        return thread;
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
        synchronized (wish) {
            wanted = true;
            pauseMillis = FIRST_PAUSE_MILLIS;
            wish.notifyAll();
        }
    }

    /** What was said before leaves first, if it leaves at once. */
    @Override
    public void drop() {
        closeChannel();
    }

    @Override
    public void hangUp() {
        synchronized (wish) {
            wanted = false;
        }
        // the goodbye leaves through the queue; an empty packet closes behind it
        if (!outgoing.offer(new byte[0])) {
            closeChannel();
        }
    }

    /** Stops the robot and says goodbye, if that can be done at once. */
    @Override
    public void close() {
        simulation.execute(() -> pioneer.setPower(false));
        synchronized (wish) {
            closed = true;
            wish.notifyAll();
        }
        try {
            liner.join(GOODBYE_MILLIS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        closeChannel();
    }

    private void closeChannel() {
        ByteChannel open = channel;
        if (open != null) {
            try {
                open.close();
            } catch (IOException e) {
                LOG.log(Level.DEBUG, "closing failed", e);
            }
        }
    }

    // ---- threads of its own --------------------------------------------------------------------------------------

    private void keepConnected() {
        try {
            while (awaitWish()) {
                try (ByteChannel open = address.open()) {
                    outgoing.clear();
                    channel = open;
                    if (isWanted()) {
                        simulation.execute(() -> pioneer.connected(System.nanoTime()));
                        read(open);
                        LOG.log(Level.INFO, robot + ": the line to the Pioneer at " + address + " has ended");
                    }
                } catch (AsynchronousCloseException e) {
                    LOG.log(Level.INFO, robot + ": the line to the Pioneer at " + address + " was closed");
                } catch (IOException | UnresolvedAddressException e) {
                    LOG.log(Level.WARNING, robot + ": no Pioneer at " + address + " (" + e.getMessage() + ")");
                }
                channel = null;
                simulation.execute(pioneer::disconnected);
                pause();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private boolean isWanted() {
        synchronized (wish) {
            return wanted && !closed;
        }
    }

    private boolean awaitWish() throws InterruptedException {
        synchronized (wish) {
            while (!wanted && !closed) {
                wish.wait();
            }
            return !closed;
        }
    }

    /** Longer each time; a new wish ends it. */
    private void pause() throws InterruptedException {
        synchronized (wish) {
            long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(pauseMillis);
            long before = pauseMillis;
            pauseMillis = Math.min(LONGEST_PAUSE_MILLIS, 2 * pauseMillis);
            long grown = pauseMillis;
            for (long left = before; left > 0 && !closed && pauseMillis == grown; ) {
                wish.wait(left);
                left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
            }
        }
    }

    private void read(ByteChannel open) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(CHUNK);
        while (open.read(buffer) >= 0) {
            if (buffer.position() > 0) {
                byte[] bytes = new byte[buffer.flip().remaining()];
                buffer.get(bytes);
                buffer.clear();
                simulation.execute(() -> pioneer.received(bytes, System.nanoTime()));
                answered();
            }
        }
    }

    /** Somebody is there: the next loss is a new one. */
    private void answered() {
        synchronized (wish) {
            pauseMillis = FIRST_PAUSE_MILLIS;
        }
    }

    private void write() {
        try {
            while (true) {
                byte[] packet = outgoing.take();
                ByteChannel open = channel;
                if (packet.length == 0) {
                    closeChannel();
                } else if (open != null) {
                    write(open, packet);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void write(ByteChannel open, byte[] packet) {
        try {
            ByteBuffer rest = ByteBuffer.wrap(packet);
            while (rest.hasRemaining()) {
                open.write(rest);
            }
        } catch (IOException e) {
            closeChannel();
        }
    }

    private void keepTime() {
        try {
            while (true) {
                Thread.sleep(TICK_MILLIS);
                if (tickPosted.compareAndSet(false, true)) {
                    simulation.execute(() -> {
                        tickPosted.set(false);
                        pioneer.tick(System.nanoTime());
                    });
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
