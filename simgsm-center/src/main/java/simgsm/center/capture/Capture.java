package simgsm.center.capture;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.time.Instant;
import java.util.concurrent.atomic.AtomicInteger;
import simgsm.thread.DaemonThread;

/**
 * A running capture. A thread writes the packets, so adding one never waits for the disk. A full disk ends the capture;
 * a slow one causes dropped packets. Both are logged, and the centre continues.
 */
public final class Capture implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Capture.class.getName());
    /** Maximum of waiting packets; at most two such buffers exist. */
    private static final int MOST_WAITING_OCTETS = 16 * 1024 * 1024;

    /** Time of collecting packets for one write. */
    private static final int GATHERING_MILLIS = 50;

    private static final long NANOS_PER_MICRO = 1_000;

    private final CapturePlan plan;
    private final Thread thread = DaemonThread.of("capture", this::run);
    private final Object lock = new Object();
    private final AtomicInteger sessions = new AtomicInteger();
    private PcapFile file;
    private PacketBuffer filling = new PacketBuffer(MOST_WAITING_OCTETS);
    private PacketBuffer writing = new PacketBuffer(MOST_WAITING_OCTETS);
    private long leftOut;
    private boolean isEnded;

    private Capture(CapturePlan plan) throws IOException {
        this.plan = plan;
        this.file = PcapFile.create(plan.file());
        // the file always holds whole records, so the thread may end with the process
        thread.start();
    }

    /**
     * Starts a capture.
     *
     * @throws IOException naming the file that cannot be written
     */
    public static Capture start(CapturePlan plan) throws IOException {
        try {
            return new Capture(plan);
        } catch (IOException e) {
            throw new IOException("cannot capture to " + plan.file() + ": " + reason(e), e);
        }
    }

    private static String reason(IOException e) {
        if (e instanceof java.nio.file.NoSuchFileException) {
            return "no such folder";
        }
        return e instanceof java.nio.file.AccessDeniedException ? "access denied" : e.getMessage();
    }

    /** The packets of a new connection. */
    public WireTap conversation(InetSocketAddress peer, InetSocketAddress center) {
        return new TcpConversation(this, peer, center);
    }

    /** The number of the next session of speech, from 0. */
    int nextSession() {
        return sessions.getAndIncrement();
    }

    /** Adds one IP packet with its header. */
    void packet(byte[] packet) {
        Instant now = Instant.now();
        synchronized (lock) {
            if (isEnded) {
                return;
            }
            if (filling.isEmpty()) {
                lock.notifyAll();
            }
            boolean isTaken = filling.add((int) now.getEpochSecond(), (int) (now.getNano() / NANOS_PER_MICRO), packet);
            if (!isTaken && leftOut++ == 0) {
                LOG.log(Level.WARNING, "capture {0}: the disk is too slow, packets are left out", plan.file());
            }
        }
    }

    private void run() {
        try {
            while (takeTurn()) {
                write();
            }
            file.close();
        } catch (IOException e) {
            end();
            LOG.log(Level.WARNING, "capture {0} has stopped: {1}", plan.file(), reason(e));
            file.abandon();
        }
    }

    /**
     * Waits for packets.
     *
     * @return false at the end of all packets
     */
    private boolean takeTurn() {
        synchronized (lock) {
            try {
                while (filling.isEmpty() && !isEnded) {
                    lock.wait();
                }
                if (!isEnded) {
                    lock.wait(GATHERING_MILLIS);
                }
            } catch (InterruptedException e) {
                isEnded = true;
            }
            PacketBuffer full = filling;
            filling = writing;
            writing = full;
            return !full.isEmpty();
        }
    }

    private void write() throws IOException {
        if (file.size() + writing.length() > plan.limitOctets()) {
            file = file.startAnew(plan.previous());
        }
        file.write(writing);
        writing.clear();
    }

    private void end() {
        synchronized (lock) {
            isEnded = true;
            lock.notifyAll();
        }
    }

    /** Writes the remaining packets and ends the capture. */
    @Override
    public void close() {
        end();
        DaemonThread.join(thread, 0);
        if (leftOut > 0) {
            LOG.log(Level.WARNING, "capture {0}: {1} packets were left out", plan.file(), leftOut);
        }
    }
}
