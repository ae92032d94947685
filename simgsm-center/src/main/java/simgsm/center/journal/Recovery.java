package simgsm.center.journal;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.util.Collection;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.LongStream;

/**
 * Reads the newest whole snapshot and the segments after it into the journal's state. An incomplete snapshot counts
 * only if the files that it replaced are gone. Unreadable octets are copied to a separate file before they are cut off.
 */
final class Recovery {
    private static final System.Logger LOG = System.getLogger(Journal.class.getName());

    /** Means no snapshot; segments are numbered from 1. */
    private static final long NONE = 0;

    /** Octets copied at once. */
    private static final int COPIED_OCTETS = 1 << 20;

    private final Disk disk;
    private final JournalState state;
    private final SharedValues shared = new SharedValues();
    private final RecoveryReport report = new RecoveryReport();
    private long lastNumber;
    /** The last segment read; null if none was. */
    private FileContents before;

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

    /** Records of the last segment; 0 if there is none. */
    long lastRecords() {
        return before == null ? 0 : before.writtenRecords();
    }

    /** Valid octets read. */
    long octets() {
        return octets;
    }

    int segments() {
        return segments;
    }

    RecoveryReport report() {
        return report;
    }

    /** @param names of the disk's files */
    void run(Set<String> names) throws IOException {
        NavigableSet<Long> snapshots = numbers(names, FileNames::snapshotNumber);
        long base = newestUsable(snapshots, names);
        if (base != NONE) {
            replaySnapshot(base);
            lastNumber = base;
        }
        NavigableSet<Long> segmentNumbers =
                numbers(names, FileNames::segmentNumber).tailSet(base, false);
        NavigableSet<Long> further = snapshots.tailSet(base, false);
        NavigableSet<Long> rest = new TreeSet<>(segmentNumbers);
        rest.addAll(further);
        for (long number : rest) {
            if (segmentNumbers.contains(number)) {
                replaySegment(number, number == segmentNumbers.last());
            }
            if (further.contains(number)) {
                replayIfNeeded(number, base, segmentNumbers);
            }
        }
        if (lastNumber != NONE) {
            disk.sync();
        }
        removeSuperseded(names, base);
        report.log(LOG, state.messages());
    }

    private static NavigableSet<Long> numbers(Set<String> names, Function<String, Optional<Long>> numberOf) {
        return names.stream().map(numberOf).flatMap(Optional::stream).collect(Collectors.toCollection(TreeSet::new));
    }

    /** The newest snapshot that is whole, or whose replaced files are gone; 0 if there is none. */
    private long newestUsable(NavigableSet<Long> snapshots, Set<String> names) throws IOException {
        for (long number : snapshots.descendingSet()) {
            boolean hasOlder = names.stream().anyMatch(name -> FileNames.isSuperseded(name, number));
            if (!hasOlder || SnapshotProof.isWhole(disk, FileNames.snapshot(number))) {
                return number;
            }
        }
        return NONE;
    }

    /** Reads an incomplete snapshot for its valid entries, unless all segments that it replaces exist. */
    private void replayIfNeeded(long number, long base, Collection<Long> segmentNumbers) throws IOException {
        String name = FileNames.snapshot(number);
        boolean isReplaced = LongStream.rangeClosed(base + 1, number).allMatch(segmentNumbers::contains);
        if (isReplaced) {
            LOG.log(Level.WARNING, "{0}: is not whole; the segments that it was to replace are read", name);
        } else {
            replaySnapshot(number);
        }
        lastNumber = Math.max(lastNumber, number);
    }

    private void replaySnapshot(long number) throws IOException {
        String name = FileNames.snapshot(number);
        FileContents read = replay(name);
        if (read.isOfFirstFormat()) {
            LOG.log(Level.WARNING, "{0}: has no end mark, as version 1.0.0 wrote it", name);
        } else if (!read.isClosed()) {
            report.lostUnknown(name + ": its end is missing");
        }
        report.lost(name, read.lostRecords());
    }

    private void replaySegment(long number, boolean isLast) throws IOException {
        String name = FileNames.segment(number);
        FileContents read = replay(name);
        if (number != lastNumber + 1) {
            report.lostUnknown(FileNames.segment(lastNumber + 1) + ": is missing");
            before = null;
        }
        if (before != null && read.isOpened()) {
            report.lost(FileNames.segment(lastNumber) + ", its end", read.previousRecords() - before.writtenRecords());
        } else if (before != null && before.cutOctets() > 0) {
            report.lostUnknown(FileNames.segment(lastNumber) + ": its end is damaged");
        }
        report.lost(name, read.lostRecords());
        if (isLast && read.cutOctets() > 0 && !read.isTornAsByDeath()) {
            report.lostUnknown(name + ": is damaged from its beginning");
        }
        lastNumber = number;
        before = read;
        segments++;
    }

    private FileContents replay(String name) throws IOException {
        try (DiskFile file = disk.open(name)) {
            FileContents contents = new FileContents();
            RecordReader reader = new RecordReader(name, file, report::damaged);
            for (byte[] record = reader.next(); record != null; record = reader.next()) {
                Optional<FileMark> mark = FileMark.decode(record);
                contents.add(mark);
                if (mark.isEmpty()) {
                    apply(name, record);
                }
            }
            contents.ended(reader);
            octets += reader.goodEnd();
            boolean isKept = true;
            for (Damage damage : report.damagesOf(name)) {
                isKept &= isPutAside(file, damage);
            }
            if (reader.goodEnd() < file.size() && isKept) {
                cut(name, file, reader.goodEnd());
            }
            // an earlier process may have ended before it synchronised the file
            file.sync();
            return contents;
        }
    }

    private void apply(String name, byte[] record) {
        try {
            state.apply(EntryCodec.decode(record, shared));
        } catch (IOException e) {
            report.lost(name + ": " + e.getMessage(), 1);
        }
    }

    /**
     * Copies the octets to a separate file.
     *
     * @return true if that has succeeded
     */
    private boolean isPutAside(DiskFile file, Damage damage) {
        String copyName = FileNames.damaged(damage.file(), damage.from());
        try (DiskFile copy = disk.create(copyName)) {
            for (long at = damage.from(); at < damage.to(); at += COPIED_OCTETS) {
                ByteBuffer piece = ByteBuffer.allocate((int) Math.min(COPIED_OCTETS, damage.to() - at));
                file.read(piece, at);
                copy.write(piece.flip(), at - damage.from());
            }
            copy.sync();
            disk.sync();
            return true;
        } catch (IOException e) {
            report.notKept(damage, copyName + ": cannot be written: " + e.getMessage());
            return false;
        }
    }

    /** Cuts off a tail; one that cannot be cut remains, and no record is written after it. */
    private static void cut(String name, DiskFile file, long end) {
        try {
            file.truncate(end);
            file.sync();
        } catch (IOException e) {
            LOG.log(Level.WARNING, "{0}: cannot be cut: {1}", name, e.getMessage());
        }
    }

    /** Deletes the files replaced by a proven snapshot, and the unfinished one of an interrupted compaction. */
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
