package simgsm.center.journal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.center.smsc.StoreEntry;

/** The thread that owns the journal: groups, answers, and its end by an error. */
class JournalThreadTest {
    private static final int PATIENCE_SECONDS = 20;

    private static final Msisdn NUMBER = new Msisdn("5550100");
    private static final List<StoreEntry> ENTRIES =
            List.of(new StoreEntry.Known(NUMBER, Imsi.ofOpenNumber(NUMBER)), new StoreEntry.Numbered(7));

    private record Answer(List<Long> tickets, boolean isDurable) {}

    private final SimulatedDisk disk = new SimulatedDisk(new Random(1));
    private final BlockingQueue<Answer> answers = new ArrayBlockingQueue<>(100);
    private final CompletableFuture<Throwable> failure = new CompletableFuture<>();

    private JournalThread started(Disk used) throws IOException {
        JournalThread thread = new JournalThread(
                Journal.open(used), (tickets, isDurable) -> answers.add(new Answer(tickets, isDurable)));
        thread.start(failure::complete);
        return thread;
    }

    private Answer answer() throws InterruptedException {
        return answers.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
    }

    @Test
    void allEntriesOfACommitAreStoredBeforeItsTicketIsAnswered() throws Exception {
        try (JournalThread thread = started(disk)) {
            thread.commit(5, ENTRIES);
            assertEquals(new Answer(List.of(5L), true), answer());
        }
        assertEquals(7, Journal.open(disk).stored().lastId());
        assertEquals(1, Journal.open(disk).stored().subscribers().size());
    }

    @Test
    void anErrorOnTheThreadIsReportedOnce() throws Exception {
        JournalThread thread = started(disk);
        disk.dieAfter(0);
        thread.commit(5, ENTRIES);
        assertInstanceOf(SimulatedDisk.MachineDied.class, failure.get(PATIENCE_SECONDS, TimeUnit.SECONDS));
        thread.close();
        assertEquals(0, answers.size(), "nothing is said to be durable");
    }

    @Test
    void anExceptionOfOurOwnInACommitIsReported() throws Exception {
        JournalThread thread = started(disk);
        StoreEntry broken = new StoreEntry.Known(null, null);
        thread.commit(5, List.of(broken));
        assertInstanceOf(NullPointerException.class, failure.get(PATIENCE_SECONDS, TimeUnit.SECONDS));
    }

    /** Lists its names like {@code Files.list}, which reports errors unchecked. */
    private Disk diskWhoseNamesCannotBeListed() {
        return new Disk() {
            private boolean isRead;

            @Override
            public Set<String> names() throws IOException {
                if (isRead) {
                    throw new UncheckedIOException(new IOException("no names today"));
                }
                isRead = true;
                return disk.names();
            }

            @Override
            public DiskFile create(String name) throws IOException {
                return disk.create(name);
            }

            @Override
            public DiskFile open(String name) throws IOException {
                return disk.open(name);
            }

            @Override
            public void rename(String from, String to) throws IOException {
                disk.rename(from, to);
            }

            @Override
            public void delete(String name) throws IOException {
                disk.delete(name);
            }

            @Override
            public void sync() throws IOException {
                disk.sync();
            }
        };
    }

    @Test
    void aCompactionThatCannotListTheDirectoryIsOverAndTheJournalGoesOn() throws Exception {
        Journal journal = Journal.open(diskWhoseNamesCannotBeListed(), new Journal.Limits(200, 20));
        boolean hasBegun = false;
        for (int id = 1; !hasBegun || journal.isCompacting(); id++) {
            journal.commit(List.of(new StoreEntry.Numbered(id)));
            journal.compact();
            hasBegun |= journal.isCompacting();
        }
        journal.commit(List.of(new StoreEntry.Numbered(1_000_000)));
        assertEquals(1_000_000, Journal.open(disk).stored().lastId());
    }

    @Test
    void aFileDiskReportsAnUnreadableDirectoryAsAnInputOutputError() {
        FileDisk missing = new FileDisk(java.nio.file.Path.of("no such directory"));
        assertThrows(IOException.class, missing::names);
    }
}
