package simgsm.center.records;

import java.io.BufferedWriter;
import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * Writes records to {@code cdr-YYYY-MM-DD.csv}, the day of their end in UTC; a file of that day is continued. A thread of its
 * own writes, so the exchange never waits for the disk; what does not fit its queue is left out, counted and logged.
 */
public final class RecordFiles implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(RecordFiles.class.getName());
    private static final int MOST_WAITING = 100_000;
    /** In the queue: no record follows. */
    private static final Object END = new Object();

    private final Path folder;
    private final BlockingQueue<Object> queue = new LinkedBlockingQueue<>(MOST_WAITING);
    private final Thread thread = new Thread(this::run, "records");
    private LocalDate day;
    private BufferedWriter file;
    private long leftOut;

    private RecordFiles(Path folder) {
        this.folder = folder;
        thread.setDaemon(true);
    }

    /**
     * Begins to write to files in a folder, which is made if it is missing.
     *
     * @throws IOException naming the folder that cannot be written
     */
    public static RecordFiles in(Path folder) throws IOException {
        RecordFiles files = new RecordFiles(folder);
        try {
            Files.createDirectories(folder);
            files.begin(LocalDate.now(ZoneOffset.UTC));
        } catch (IOException e) {
            throw new IOException("cannot write records to " + folder + ": " + e.getMessage(), e);
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
        if (!queue.offer(detail) && leftOut++ == 0) {
            LOG.log(Level.WARNING, "records in {0}: the disk is too slow, records are left out", folder);
        }
    }

    private void begin(LocalDate newDay) throws IOException {
        Path path = file(folder, newDay);
        file = Files.newBufferedWriter(
                path, StandardCharsets.UTF_8, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        day = newDay;
        if (Files.size(path) == 0) {
            writeLine(DetailRecord.HEADER);
            file.flush();
        }
    }

    private void writeLine(String line) throws IOException {
        file.write(line);
        file.write("\r\n");
    }

    private void run() {
        List<Object> taken = new ArrayList<>();
        try {
            boolean isOver = false;
            while (!isOver) {
                taken.add(queue.take());
                queue.drainTo(taken);
                for (Object next : taken) {
                    if (next instanceof DetailRecord detail) {
                        write(detail);
                    }
                    isOver |= next == END;
                }
                taken.clear();
                file.flush();
            }
            file.close();
        } catch (IOException e) {
            LOG.log(Level.ERROR, "records in {0} have ended: {1}", folder, e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void write(DetailRecord detail) throws IOException {
        LocalDate ended = LocalDate.ofInstant(detail.ended(), ZoneOffset.UTC);
        if (!ended.equals(day)) {
            file.close();
            begin(ended);
        }
        writeLine(detail.line());
    }

    /** Writes what waits and ends. */
    @Override
    public void close() {
        try {
            queue.put(END);
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (leftOut > 0) {
            LOG.log(Level.WARNING, "records in {0}: {1} were left out", folder, leftOut);
        }
    }
}
