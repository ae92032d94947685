package simgsm.center.journal;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Reads the latest snapshot and the segments after it into the journal's state. */
final class Recovery {
    private static final System.Logger LOG = System.getLogger(Journal.class.getName());

    /** The number of no snapshot; segments are numbered from 1. */
    private static final long NONE = 0;

    private final Disk disk;
    private final JournalState state;
    private long lastNumber;
    private long octets;
    private int segments;

    Recovery(Disk disk, JournalState state) {
        this.disk = disk;
        this.state = state;
    }

    /** The highest number of a segment or snapshot; 0 if there is none. */
    long lastNumber() {
        return lastNumber;
    }

    /** Valid octets read. */
    long octets() {
        return octets;
    }

    int segments() {
        return segments;
    }

    void run() throws IOException {
        Set<String> names = disk.names();
        long snapshot = numbers(names, FileNames::snapshotNumber).stream().reduce(NONE, Math::max);
        if (snapshot != NONE) {
            replay(FileNames.snapshot(snapshot));
        }
        lastNumber = snapshot;
        for (long number : numbers(names, FileNames::segmentNumber)) {
            if (number > snapshot) {
                replaySegment(number);
            }
        }
        if (lastNumber != NONE) {
            disk.sync();
        }
        removeSuperseded(names, snapshot);
    }

    private static Set<Long> numbers(Set<String> names, Function<String, Optional<Long>> numberOf) {
        return names.stream().map(numberOf).flatMap(Optional::stream).collect(Collectors.toCollection(TreeSet::new));
    }

    private void replaySegment(long number) throws IOException {
        if (number != lastNumber + 1) {
            LOG.log(Level.WARNING, "{0} is missing", FileNames.segment(lastNumber + 1));
        }
        lastNumber = number;
        segments++;
        replay(FileNames.segment(number));
    }

    private void replay(String name) throws IOException {
        try (DiskFile file = disk.open(name)) {
            RecordReader reader = new RecordReader(name, file, Recovery::report);
            for (byte[] record = reader.next(); record != null; record = reader.next()) {
                apply(name, record);
            }
            octets += reader.goodEnd();
            if (reader.goodEnd() < file.size()) {
                cut(name, file, reader.goodEnd());
            }
            // An earlier process may have ended before it synchronised the file.
            file.sync();
        }
    }

    private static void report(Damage damage) {
        LOG.log(Level.WARNING, damage::toString);
    }

    private void apply(String name, byte[] record) {
        try {
            state.apply(EntryCodec.decode(record));
        } catch (IOException e) {
            LOG.log(Level.WARNING, "{0}: {1}; skipped", name, e.getMessage());
        }
    }

    /** A tail that cannot be cut stays: no record is ever written after it. */
    private static void cut(String name, DiskFile file, long end) {
        try {
            file.truncate(end);
            file.sync();
        } catch (IOException e) {
            LOG.log(Level.WARNING, "{0}: cannot be cut: {1}", name, e.getMessage());
        }
    }

    /** Deletes the replaced files and the unfinished snapshot of a compaction that a crash has interrupted. */
    private void removeSuperseded(Set<String> names, long snapshot) {
        for (String name : names) {
            if (FileNames.isSuperseded(name, snapshot) || name.equals(FileNames.unfinished())) {
                try {
                    disk.delete(name);
                } catch (IOException e) {
                    LOG.log(Level.WARNING, "{0}: cannot be deleted: {1}", name, e.toString());
                }
            }
        }
    }
}
