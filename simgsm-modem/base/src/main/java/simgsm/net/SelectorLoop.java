package simgsm.net;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import simgsm.thread.DaemonThread;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * One thread with one selector, which owns sockets, timers and a core. Each iteration serves the ready channels once,
 * then expired timers, then the tasks posted before the iteration, then the core's deadline; at its end it flushes
 * the connections with output. An exception ends the connection or the task in which it occurs; an {@link Error}, or
 * a failing selector, ends the loop and is reported to the failure handler.
 *
 * <p>{@link #post}, {@link #ask}, {@link #listen} and {@link #close} may be called by any thread, everything else
 * only by the loop's own. Times are those of {@link System#nanoTime}.
 */
public final class SelectorLoop implements AutoCloseable {
    /** The state machine that a loop drives. */
    public interface Core {
        /** A core without deadlines. */
        Core NONE = new Core() {};

        /** Time of the next call of {@link #advance}; {@link #NEVER} for no deadline. */
        default long nextDeadlineNanos() {
            return NEVER;
        }

        default void advance(long nowNanos) {}

        /** The loop has ended and all its connections are closed; the last call. */
        default void ended() {}
    }

    /** Later than any deadline. */
    public static final long NEVER = Long.MAX_VALUE;

    private static final System.Logger LOG = System.getLogger(SelectorLoop.class.getName());
    private static final int READ_BUFFER_OCTETS = 64 * 1024;
    private static final long NANOS_PER_MILLI = 1_000_000;
    /** A task takes milliseconds; a loop that needs longer is overloaded or blocked. */
    private static final Duration ASK_LIMIT = Duration.ofSeconds(5);

    private final String name;
    private final Duration askLimit;
    private final Selector selector;
    private final Thread thread;
    private final LinkedBlockingQueue<Runnable> mailbox = new LinkedBlockingQueue<>();
    private final ArrayDeque<Runnable> batch = new ArrayDeque<>();
    private final AtomicBoolean isWoken = new AtomicBoolean();
    private final Queue<Connection> withOutput = new ArrayDeque<>();
    private final Queue<Runnable> afterAction = new ArrayDeque<>();
    private final ByteBuffer readBuffer = ByteBuffer.allocateDirect(READ_BUFFER_OCTETS);
    private final Timers timers = new Timers();
    private final long originNanos = System.nanoTime();
    private Core core = Core.NONE;
    private Consumer<Throwable> onFailure = fault -> {};
    private volatile boolean isEnding;
    private volatile boolean isEnded;

    /**
     * Creates a loop that is not started; its thread is a daemon.
     *
     * @param name of the thread
     */
    public SelectorLoop(String name) {
        this(name, ASK_LIMIT);
    }

    SelectorLoop(String name, Duration askLimit) {
        this.name = name;
        this.askLimit = askLimit;
        try {
            selector = Selector.open();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        thread = DaemonThread.of(name, this::run);
    }

    /**
     * Starts the thread.
     *
     * @param newCore driven from now on
     * @param failureHandler called by the loop's thread if the loop ends without {@link #end} or {@link #close}
     */
    public void start(Core newCore, Consumer<Throwable> failureHandler) {
        core = newCore;
        onFailure = failureHandler;
        thread.start();
    }

    /** True if the calling thread is the loop's own. */
    public boolean isOwner() {
        return Thread.currentThread() == thread;
    }

    /**
     * Queues a task; tasks keep their order. A task that throws is logged.
     *
     * @return false if the loop has ended; the task is not run
     */
    public boolean post(Runnable task) {
        mailbox.add(task);
        if (isEnded) {
            rejectTasks();
            return false;
        }
        if (!isOwner() && isWoken.compareAndSet(false, true)) {
            selector.wakeup();
        }
        return true;
    }

    /**
     * Runs a question on the loop's thread and returns its answer, or throws its exception.
     *
     * @throws IllegalStateException if the loop has ended, or has not begun the question within 5 s; it is dropped
     *     then
     */
    public <T> T ask(Callable<T> question) {
        FutureTask<T> task = new FutureTask<>(question);
        if (isOwner()) {
            task.run();
        } else {
            post(task);
        }
        try {
            return task.get(askLimit.toNanos(), TimeUnit.NANOSECONDS);
        } catch (CancellationException e) {
            throw new IllegalStateException("the thread " + name + " has ended", e);
        } catch (TimeoutException e) {
            throw new IllegalStateException(
                    "the thread " + name + " does not answer within " + askLimit.toMillis() + " ms", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while waiting for the thread " + name, e);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof RuntimeException cause) {
                throw cause;
            }
            throw new IllegalStateException("the thread " + name + " failed: " + e.getCause(), e.getCause());
        } finally {
            task.cancel(false);
        }
    }

    /**
     * Opens a port. Connections are accepted once the loop runs.
     *
     * @param address port 0 for any free one
     * @throws IOException naming address and port
     */
    public Acceptor listen(InetSocketAddress address, ConnectionLimits limits, Acceptor.Factory factory)
            throws IOException {
        Acceptor acceptor = new Acceptor(this, address, limits, factory);
        selector.wakeup();
        return acceptor;
    }

    /**
     * Opens a UDP socket for any number of peers.
     *
     * @param local port 0 for any free even one
     * @param received takes each datagram with its source, on this thread
     * @throws IOException naming address and port
     */
    public Datagrams datagrams(InetSocketAddress local, BiConsumer<byte[], InetSocketAddress> received)
            throws IOException {
        Datagrams socket = Datagrams.open(this, local, received);
        selector.wakeup();
        return socket;
    }

    /** Runs an action once, at the earliest in the next iteration. */
    public Timer after(long delayNanos, Runnable action) {
        long lateNanos = System.nanoTime() - originNanos - timers.nowNanos();
        return timers.start(lateNanos + Math.max(1, delayNanos), () -> perform(action));
    }

    public void cancel(Timer timer) {
        timers.cancel(timer);
    }

    Selector selector() {
        return selector;
    }

    ByteBuffer readBuffer() {
        return readBuffer;
    }

    /** Has the connection flushed at the end of this iteration. */
    void hasOutput(Connection connection) {
        withOutput.add(connection);
    }

    /** Runs a step once the running action has returned. */
    void afterAction(Runnable step) {
        afterAction.add(step);
    }

    /** Runs an action, then the steps added for its end. An exception is logged. */
    public void perform(Runnable action) {
        guard(action);
        for (Runnable step = afterAction.poll(); step != null; step = afterAction.poll()) {
            guard(step);
        }
    }

    private void guard(Runnable action) {
        try {
            action.run();
        } catch (RuntimeException e) {
            LOG.log(Level.ERROR, name + ": an action failed", e);
        }
    }

    private void run() {
        try {
            while (!isEnding) {
                iterate();
            }
        } catch (Throwable fault) {
            LOG.log(Level.DEBUG, name + " ends", fault);
            if (!isEnding) {
                onFailure.accept(fault);
            }
        } finally {
            release();
        }
    }

    private void iterate() throws IOException {
        long waitMillis = millisToWait();
        if (waitMillis > 0) {
            selector.select(this::ready, waitMillis);
        } else {
            selector.selectNow(this::ready);
        }
        isWoken.set(false);
        timers.advance(System.nanoTime() - originNanos);
        mailbox.drainTo(batch);
        for (Runnable task = batch.poll(); task != null; task = batch.poll()) {
            perform(task);
        }
        long now = System.nanoTime();
        if (core.nextDeadlineNanos() <= now) {
            perform(() -> core.advance(now));
        }
        for (Connection each = withOutput.poll(); each != null; each = withOutput.poll()) {
            perform(each::flush);
        }
    }

    private void ready(SelectionKey key) {
        if (key.attachment() instanceof Connection connection) {
            perform(connection::ready);
        } else {
            perform((Runnable) key.attachment());
        }
    }

    /** Time to the next deadline, rounded up; 0 if something is due now. */
    private long millisToWait() {
        if (!mailbox.isEmpty()) {
            return 0;
        }
        long next = core.nextDeadlineNanos();
        if (timers.nextDeadlineNanos().isPresent()) {
            next = Math.min(next, originNanos + timers.nextDeadlineNanos().getAsLong());
        }
        return next == NEVER
                ? Long.MAX_VALUE
                : Math.max(0, (next - System.nanoTime() + NANOS_PER_MILLI - 1) / NANOS_PER_MILLI);
    }

    private void release() {
        if (isEnded) {
            return;
        }
        for (SelectionKey key : selector.keys()) {
            if (key.attachment() instanceof Connection connection) {
                guard(connection::close);
            } else {
                close(key);
            }
        }
        try {
            selector.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, name + ": closing the selector: {0}", e.getMessage());
        }
        isEnded = true;
        mailbox.addAll(batch);
        rejectTasks();
        guard(core::ended);
    }

    private static void close(SelectionKey key) {
        try {
            key.channel().close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a channel: {0}", e.getMessage());
        }
    }

    /** Cancels waiting questions, so that their callers do not wait for the limit. */
    private void rejectTasks() {
        for (Runnable task = mailbox.poll(); task != null; task = mailbox.poll()) {
            if (task instanceof Future<?> question) {
                question.cancel(false);
            }
        }
    }

    /** Ends the loop after this iteration. */
    public void end() {
        isEnding = true;
        selector.wakeup();
    }

    /** Waits for the end of the thread, if it was started; every port and connection is closed then. */
    public void join() {
        if (thread.getState() == Thread.State.NEW) {
            release();
        } else if (!isOwner()) {
            DaemonThread.join(thread, 0);
        }
    }

    /** Ends the loop and waits for its thread. */
    @Override
    public void close() {
        end();
        join();
    }
}
