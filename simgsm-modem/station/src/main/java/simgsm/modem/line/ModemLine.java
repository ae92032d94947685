package simgsm.modem.line;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.nio.channels.AsynchronousCloseException;
import java.nio.channels.ByteChannel;
import java.nio.channels.UnresolvedAddressException;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.net.ByteLine;
import simgsm.net.SelectorLoop;
import simgsm.thread.DaemonThread;

/**
 * Line and clock of a modem's core. Serial lines block, so one thread connects and reads, and one writes; a third
 * owns the core and runs its timers. A line that is lost or cannot be opened is reopened after 1 s. Any thread may
 * call its methods.
 */
public final class ModemLine implements AutoCloseable {
    /** The core; called by its owner thread. Time is in nanoseconds since the line's creation. */
    public interface Party {
        void lineUp(long nowNanos);

        void lineDown(long nowNanos);

        void received(byte[] octets, long nowNanos);

        /** Not called for a second line, whose time is the first one's. */
        default void timePassed(long nowNanos) {}

        default long nextDeadlineNanos() {
            return NO_DEADLINE;
        }

        /** The line cannot be opened; further attempts follow. */
        default void lineFailed(String reason) {}

        /** The last call while the line is open. */
        default void closing() {}
    }

    /** A core's {@link Party#nextDeadlineNanos} without a deadline. */
    public static final long NO_DEADLINE = Long.MAX_VALUE;

    private static final Logger LOG = System.getLogger(ModemLine.class.getName());
    private static final long PAUSE_MILLIS = 1_000;
    private static final long GOODBYE_MILLIS = 1_000;
    private static final int CHUNK_OCTETS = 1_024;
    /** 100 ms: the frames of a burst are written by another thread. */
    private static final int MOST_FRAMES = 5;

    /** Closes the line after the text written before. */
    private static final byte[] END = {};

    private final String name;
    private final ByteLine address;
    private final long originNanos;
    private final SelectorLoop loop;
    /** The line whose owner thread this one shares; null for one with its own. */
    private final ModemLine first;

    private final Consumer<Throwable> onFailure;
    private final BlockingQueue<byte[]> outgoing = new LinkedBlockingQueue<>();
    private final CountDownLatch closing = new CountDownLatch(1);
    private final Thread reader;
    private final Thread writer;
    private Party party;
    private volatile ByteChannel channel;
    /** Owned by the reader's thread. */
    private boolean failureLogged;

    /**
     * A line that is not started.
     *
     * @param name of the modem and its threads
     * @param onFailure called if the owner thread ends by an error
     */
    public ModemLine(String name, ByteLine address, Consumer<Throwable> onFailure) {
        this(name, address, onFailure, null);
    }

    /** A second line of the same owner thread, whose time is the first one's. @param first to be started first */
    public ModemLine(String name, ByteLine address, ModemLine first) {
        this(name, address, first.onFailure, first);
    }

    private ModemLine(String name, ByteLine address, Consumer<Throwable> onFailure, ModemLine first) {
        this.name = name;
        this.address = address;
        this.onFailure = onFailure;
        this.first = first;
        originNanos = first == null ? System.nanoTime() : first.originNanos;
        loop = first == null ? new SelectorLoop(name) : first.loop;
        reader = DaemonThread.of(name + " reader", this::keepOpen);
        writer = DaemonThread.of(name + " writer", this::write);
    }

    /** Sets the core, before the start. @return the core */
    public <P extends Party> P attach(P core) {
        party = core;
        return core;
    }

    /** Starts the threads and opens the line. */
    public void start() {
        if (first == null) {
            startLoop();
        }
        reader.start();
        writer.start();
    }

    private void startLoop() {
        loop.start(
                new SelectorLoop.Core() {
                    @Override
                    public long nextDeadlineNanos() {
                        long next = party.nextDeadlineNanos();
                        return next == NO_DEADLINE ? SelectorLoop.NEVER : originNanos + next;
                    }

                    @Override
                    public void advance(long nowNanos) {
                        party.timePassed(nowNanos - originNanos);
                    }
                },
                onFailure);
    }

    /** Queues an action of the owner thread, run at the core's time. */
    public void execute(Runnable action) {
        loop.post(() -> {
            party.timePassed(now());
            action.run();
        });
    }

    /** Sends a text in ISO 8859-1; called by the core. */
    public void send(String text) {
        outgoing.add(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Sends a frame of a sound; the oldest of more than five waiting ones is dropped, so that none gets late. */
    public void sendFrame(byte[] octets) {
        if (outgoing.size() >= MOST_FRAMES) {
            outgoing.poll();
        }
        outgoing.add(octets);
    }

    private long now() {
        return System.nanoTime() - originNanos;
    }

    // ---- the threads -----------------------------------------------------------------------------------------------

    private void keepOpen() throws InterruptedException {
        while (closing.getCount() > 0) {
            try (ByteChannel open = address.open()) {
                outgoing.removeIf(octets -> octets != END);
                channel = open;
                failureLogged = false;
                LOG.log(Level.INFO, "the line to the " + name + " at " + address + " is open");
                loop.post(() -> party.lineUp(now()));
                read(open);
                LOG.log(Level.WARNING, "the " + name + " at " + address + " has ended the connection");
            } catch (AsynchronousCloseException e) {
                LOG.log(Level.INFO, "the line to the " + name + " at " + address + " is closed");
            } catch (IOException | UnresolvedAddressException e) {
                failed(reason(e));
            }
            channel = null;
            loop.post(() -> party.lineDown(now()));
            closing.await(PAUSE_MILLIS, TimeUnit.MILLISECONDS);
        }
    }

    private void failed(String reason) {
        if (closing.getCount() > 0) {
            LOG.log(failureLogged ? Level.DEBUG : Level.WARNING, "no " + name + " at " + address + ": " + reason);
            failureLogged = true;
            loop.post(() -> party.lineFailed(reason));
        }
    }

    private static String reason(Exception e) {
        if (e instanceof NoSuchFileException) {
            return "no such file";
        }
        return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
    }

    private void read(ByteChannel open) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(CHUNK_OCTETS);
        while (open.read(buffer) >= 0) {
            byte[] octets = new byte[buffer.flip().remaining()];
            buffer.get(octets);
            buffer.clear();
            // the owner may be late; an answer that arrived in time is in time
            long arrivedNanos = now();
            loop.post(() -> party.received(octets, arrivedNanos));
        }
    }

    private void write() throws InterruptedException {
        byte[] octets = outgoing.take();
        while (octets != END) {
            ByteChannel open = channel;
            if (open != null) {
                write(open, octets);
            }
            octets = outgoing.take();
        }
        drop();
    }

    private void write(ByteChannel open, byte[] octets) {
        try {
            ByteBuffer rest = ByteBuffer.wrap(octets);
            while (rest.hasRemaining()) {
                open.write(rest);
            }
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "writing to " + address + ": " + e.getMessage());
            drop();
        }
    }

    private void drop() {
        ByteChannel open = channel;
        if (open != null) {
            try {
                open.close();
            } catch (IOException e) {
                LOG.log(Level.DEBUG, "closing " + address + ": " + e.getMessage());
            }
        }
    }

    // ---- the end ---------------------------------------------------------------------------------------------------

    /** Ends any call and the line, without waiting. */
    public void end() {
        execute(() -> {
            party.closing();
            closing.countDown();
            outgoing.add(END);
        });
    }

    /** Ends any call, the line and the threads, and waits for at most a second. */
    @Override
    public void close() {
        end();
        DaemonThread.join(writer, GOODBYE_MILLIS);
        closing.countDown();
        drop();
        if (first == null) {
            loop.close();
        }
    }
}
