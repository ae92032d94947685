package simgsm.center.records;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.lang.System.Logger.Level;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import simgsm.center.smsc.HeapShare;
import simgsm.file.FileErrors;
import simgsm.file.PrivateFiles;
import simgsm.thread.DaemonThread;

/**
 * Writes records to {@code cdr-YYYY-MM-DD.csv}, the day of their end in UTC; an existing file is continued. A separate
 * thread writes, so the exchange never waits for the disk; records that do not fit its queue are dropped, counted and
 * logged. After an error, such as a full disk, the file is opened again with the next record, 1 s later.
 */
public final class RecordFiles implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(RecordFiles.class.getName());
    private static final int MOST_WAITING = HeapShare.count(100_000, 500);
    private static final long PAUSE_MILLIS = 1_000;
    /** Maximum wait for the disk at the end of the program. */
    private static final long GOODBYE_MILLIS = 5_000;
    /** Marks the end of the queue. */
    private static final Object END = new Object();

    private final Path folder;
    private final BlockingQueue<Object> queue = new LinkedBlockingQueue<>(MOST_WAITING);
    private final Thread thread = DaemonThread.of("records", this::run);
    private final CountDownLatch closing = new CountDownLatch(1);
    private final AtomicLong leftOut = new AtomicLong();
    private LocalDate day;
    /** Null after an error. */
    private BufferedWriter file;
    /** Number of records in the file's buffer. */
    private int unflushed;

    private boolean failureLogged;

    private RecordFiles(Path folder) {
        this.folder = folder;
    }

    /**
     * Begins to write to files in a folder, creating it if missing.
     *
     * @throws IOException naming the folder that cannot be written
     */
    public static RecordFiles in(Path folder) throws IOException {
        RecordFiles files = new RecordFiles(folder);
        try {
            PrivateFiles.makeFolder(folder);
            files.begin(LocalDate.now(ZoneOffset.UTC));
        } catch (IOException e) {
            throw new IOException("cannot write records to " + FileErrors.describe(e), e);
        }
        files.thread.start();
        return files;
    }

    /** The file of a day. */
    static Path file(Path folder, LocalDate day) {
        return folder.resolve("cdr-" + day + ".csv");
    }

    /** Queues a record. Called by one thread. */
    void add(DetailRecord detail) {
        if (!queue.offer(detail) && leftOut.getAndIncrement() == 0) {
            LOG.log(Level.WARNING, "records in {0}: the disk is too slow, records are left out", folder);
        }
    }

    private void begin(LocalDate newDay) throws IOException {
        Path path = file(folder, newDay);
        file = new BufferedWriter(Channels.newWriter(
                PrivateFiles.open(path, StandardOpenOption.CREATE, StandardOpenOption.APPEND), StandardCharsets.UTF_8));
        day = newDay;
        if (Files.size(path) == 0) {
            writeLine(DetailRecord.HEADER);
        } else if (isTorn(path)) {
            file.write("\r\n");
        }
        file.flush();
    }

    /** True if the last line is incomplete, as after a full disk. */
    private static boolean isTorn(Path path) throws IOException {
        try (RandomAccessFile octets = new RandomAccessFile(path.toFile(), "r")) {
            octets.seek(octets.length() - 1);
            return octets.read() != '\n';
        }
    }

    private void writeLine(String line) throws IOException {
        file.write(line);
        file.write("\r\n");
    }

    private interface Step {
        void run() throws IOException;
    }

    private void run() throws InterruptedException {
        List<Object> taken = new ArrayList<>();
        boolean isOver = false;
        while (!isOver) {
            taken.add(queue.take());
            queue.drainTo(taken);
            for (Object next : taken) {
                if (next instanceof DetailRecord detail) {
                    attempt(() -> write(detail));
                }
                isOver |= next == END;
            }
            taken.clear();
            attempt(this::flush);
            isOver |= closing.getCount() == 0 && queue.isEmpty();
        }
        attempt(this::closeFile);
    }

    private void attempt(Step step) throws InterruptedException {
        try {
            step.run();
        } catch (IOException e) {
            leftOut.addAndGet(unflushed);
            unflushed = 0;
            LOG.log(
                    failureLogged ? Level.DEBUG : Level.ERROR,
                    "records in {0} cannot be written, which is tried again each second: {1}",
                    folder,
                    e.getMessage());
            failureLogged = true;
            abandonFile();
            closing.await(PAUSE_MILLIS, TimeUnit.MILLISECONDS);
        }
    }

    private void write(DetailRecord detail) throws IOException {
        LocalDate ended = LocalDate.ofInstant(detail.ended(), ZoneOffset.UTC);
        boolean isOfNextDay = file != null && !ended.equals(day);
        unflushed++;
        if (isOfNextDay) {
            closeFile();
            file = null;
            unflushed = 1;
        }
        if (file == null) {
            begin(ended);
        }
        writeLine(detail.line());
    }

    private void flush() throws IOException {
        if (file != null) {
            file.flush();
            unflushed = 0;
            failureLogged = false;
        }
    }

    private void closeFile() throws IOException {
        if (file != null) {
            file.close();
        }
    }

    private void abandonFile() {
        try {
            closeFile();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a file of records: {0}", e.getMessage());
        }
        file = null;
    }

    /** Writes the queue and ends. */
    @Override
    public void close() {
        closing.countDown();
        // a full queue needs no END: the thread does not wait, and ends when it is empty
        queue.offer(END);
        DaemonThread.join(thread, GOODBYE_MILLIS);
        if (thread.isAlive()) {
            LOG.log(Level.WARNING, "records in {0}: the disk does not answer, {1} are left", folder, queue.size());
        }
        if (leftOut.get() > 0) {
            LOG.log(Level.WARNING, "records in {0}: {1} were left out", folder, leftOut);
        }
    }
}
