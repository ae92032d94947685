package blackbox;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.journal.Disk;
import simgsm.center.journal.DiskFile;
import simgsm.center.journal.FileDisk;
import simgsm.center.journal.Journal;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.center.smsc.MessageStore;
import simgsm.center.smsc.StoreEntry;
import simgsm.center.subscriber.HomeRegister;

/** The centre of a {@link VirtualSuite}, with its messages in memory or in a journal on disk; it can be killed. */
final class VirtualCenter {
    private static final Instant STARTED_AT = Instant.parse("2026-11-21T12:00:00Z");

    private final Deque<Runnable> underWay;
    private final LongSupplier clockNanos;
    private final SuiteTrace trace;
    private final HomeRegister home;
    private final Optional<Path> folder;
    /** Of the process that runs: its death ends them and their locks. */
    private final List<DiskFile> open = new ArrayList<>();

    private Exchange exchange;

    /** @param folder of the journal; without it messages are kept in memory */
    VirtualCenter(
            Deque<Runnable> underWay,
            LongSupplier clockNanos,
            SuiteTrace trace,
            HomeRegister home,
            Optional<Path> folder) {
        this.underWay = underWay;
        this.clockNanos = clockNanos;
        this.trace = trace;
        this.home = home;
        this.folder = folder;
        start();
    }

    Exchange exchange() {
        return exchange;
    }

    /** A new process: everything that is not in the journal is lost. */
    void start() {
        ExchangeSettings settings = new ExchangeSettings(
                "SimGSM",
                new SplittableRandom(1),
                STARTED_AT,
                home,
                Optional.empty(),
                true,
                Locale.ENGLISH,
                false,
                NetworkTimer.T303.nanos(),
                Optional.empty(),
                HandoverAlgorithm.STANDARD);
        if (folder.isEmpty()) {
            exchange = new Exchange(settings, (ticket, entries) -> committed(exchange, ticket), event -> {});
            return;
        }
        try {
            for (DiskFile file : open) {
                file.close();
            }
            open.clear();
            Journal journal = Journal.open(new TracedDisk(new FileDisk(folder.get())));
            exchange = new Exchange(settings, new TracedStore(journal), event -> {});
            trace.stored("Journal", "M3", "restore messages and subscribers");
            exchange.restore(journal.stored());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void committed(Exchange owner, long ticket) {
        underWay.add(() -> {
            if (owner == exchange) {
                owner.committed(clockNanos.getAsLong(), ticket, true);
            }
        });
    }

    /** Groups of one entry: each is durable before the next frame is handled. */
    private final class TracedStore implements MessageStore {
        private final Journal journal;

        TracedStore(Journal journal) {
            this.journal = journal;
        }

        @Override
        public void commit(long ticket, List<StoreEntry> entries) {
            String names = entries.stream()
                    .map(entry -> entry.getClass().getSimpleName())
                    .distinct()
                    .collect(Collectors.joining(", "));
            trace.stored("M3", "Journal", "commit: " + names);
            journal.commit(entries);
            if (ticket != NO_TICKET) {
                trace.stored("Journal", "M3", "durable: " + names);
            }
            committed(exchange, ticket);
        }
    }

    private final class TracedDisk implements Disk {
        private final Disk disk;

        TracedDisk(Disk disk) {
            this.disk = disk;
        }

        @Override
        public Set<String> names() throws IOException {
            return disk.names();
        }

        @Override
        public DiskFile create(String name) throws IOException {
            trace.stored("Journal", "Disk", "create a segment");
            return new TracedFile(disk.create(name));
        }

        @Override
        public DiskFile open(String name) throws IOException {
            trace.stored("Journal", "Disk", "read a segment");
            return new TracedFile(disk.open(name));
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
    }

    private final class TracedFile implements DiskFile {
        private final DiskFile file;

        TracedFile(DiskFile file) {
            this.file = file;
            open.add(file);
        }

        @Override
        public long size() throws IOException {
            return file.size();
        }

        @Override
        public void read(ByteBuffer into, long position) throws IOException {
            file.read(into, position);
        }

        @Override
        public void write(ByteBuffer octets, long position) throws IOException {
            file.write(octets, position);
        }

        @Override
        public void truncate(long size) throws IOException {
            file.truncate(size);
        }

        @Override
        public void sync() throws IOException {
            trace.stored("Journal", "Disk", "write and fsync");
            file.sync();
        }

        @Override
        public void close() throws IOException {
            file.close();
        }
    }
}
