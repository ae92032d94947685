package simgsm.center.journal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import simgsm.center.smsc.HeapShare;
import simgsm.center.smsc.StoreEntry;
import simgsm.center.smsc.StoredState;

/**
 * The store on disk: groups of entries appended to segments, and occasional snapshots that replace all earlier
 * segments. Without thread and clock; one owner drives it.
 *
 * <p>While the disk fails, new messages are refused. Entries of other kinds report past events; they are kept in memory
 * and written first after the recovery.
 */
public final class Journal {
    private static final System.Logger LOG = System.getLogger(Journal.class.getName());

    /**
     * Sizes; tests use smaller ones.
     *
     * @param segmentOctets a larger segment is closed and followed by the next
     * @param minCompactedOctets no compaction below this size on disk
     * @param mostWaste compaction begins when the files are larger than their state by this factor
     * @param mostSegments compaction begins when there are more
     * @param maxRecent messages kept to recognise repetitions
     */
    record Limits(long segmentOctets, long minCompactedOctets, int mostWaste, int mostSegments, int maxRecent) {
        static final Limits STANDARD = new Limits(16 << 20, 4 << 20, 3, 32, HeapShare.count(20_000, 500));

        Limits(long minCompactedOctets, int maxRecent) {
            this(STANDARD.segmentOctets, minCompactedOctets, STANDARD.mostWaste, STANDARD.mostSegments, maxRecent);
        }
    }

    /** Space reserved for the ends of 79 000 messages. */
    private static final long RESERVE_OCTETS = 4 << 20;

    private final Disk disk;
    private final Limits limits;
    private final JournalState state;
    /** Entries not yet on disk, in order; repetitions are kept once. */
    private final Set<StoreEntry> owed = new LinkedHashSet<>();

    private final DiskReserve reserve;
    private JournalSegment segment;
    /** True if the segment was the reserve: the disk is full. */
    private boolean isReserve;

    /** True if the segment may contain octets of a failed append. */
    private boolean isSuspect;

    private boolean isFailing;
    private Compaction compaction;
    private long lastNumber;
    /** Records in the last closed segment. */
    private long lastRecords;
    /** Octets in closed files, and the part replaced by the running compaction. */
    private long closedOctets;

    private long replacedOctets;
    private int segments;
    private long compactAboveOctets;

    private Journal(Disk disk, Limits limits, DiskReserve reserve) {
        this.disk = disk;
        this.reserve = reserve;
        this.limits = limits;
        this.state = new JournalState(limits.maxRecent);
        this.compactAboveOctets = limits.minCompactedOctets;
    }

    /**
     * Reads the directory; logs damage by file and position, and keeps the valid records.
     *
     * @throws IOException if the disk cannot be read
     */
    public static Journal open(Disk disk) throws IOException {
        return open(disk, Limits.STANDARD);
    }

    static Journal open(Disk disk, Limits limits) throws IOException {
        Set<String> names = disk.names();
        Journal journal = new Journal(disk, limits, new DiskReserve(disk, names));
        Recovery recovery = new Recovery(disk, journal.state);
        recovery.run(names);
        journal.lastNumber = recovery.lastNumber();
        journal.lastRecords = recovery.lastRecords();
        journal.closedOctets = recovery.octets();
        journal.segments = recovery.segments();
        return journal;
    }

    /** Reserves disk space for the ends of messages when the disk is full. */
    public void holdReserve() {
        holdReserve(RESERVE_OCTETS);
    }

    void holdReserve(long octets) {
        reserve.hold(octets);
        if (!reserve.isFilled()) {
            LOG.log(
                    Level.WARNING,
                    "the disk is full: {0} octets are held back for the ends of messages, expected {1}",
                    reserve.size(),
                    octets);
        }
    }

    /** The sum of all entries so far. */
    public StoredState stored() {
        return state.stored();
    }

    /**
     * Makes entries durable, all or none.
     *
     * @return true if that has succeeded
     */
    public boolean commit(List<StoreEntry> entries) {
        List<StoreEntry> all = new ArrayList<>(owed.size() + entries.size());
        all.addAll(owed);
        all.addAll(entries);
        try {
            prepare();
            append(all);
        } catch (IOException | UncheckedIOException e) {
            failed(entries, e);
            return isSaved() && entries.stream().noneMatch(StoreEntry.Accepted.class::isInstance);
        }
        // a commit without a write does not show if there is space
        if (isFailing && !all.isEmpty()) {
            LOG.log(Level.WARNING, "the disk takes the journal again");
            isFailing = false;
            reserve.isFilled();
        }
        return true;
    }

    private void append(List<StoreEntry> entries) throws IOException {
        isSuspect = true;
        segment.append(entries, true);
        isSuspect = false;
        owed.clear();
        entries.forEach(state::apply);
    }

    /** True if the last commit has failed; an empty commit retries the kept entries. */
    public boolean isFailing() {
        return isFailing;
    }

    private void failed(List<StoreEntry> refused, Exception e) {
        LOG.log(isFailing ? Level.DEBUG : Level.ERROR, "the disk does not take the journal: {0}", e.toString());
        isFailing = true;
        for (StoreEntry entry : refused) {
            if (!(entry instanceof StoreEntry.Accepted)) {
                owed.add(entry);
            }
        }
    }

    /**
     * Writes the kept entries to the reserve.
     *
     * @return true if none is left
     */
    private boolean isSaved() {
        try {
            if (!owed.isEmpty() && !isReserve) {
                beginReserve();
            }
            if (!owed.isEmpty()) {
                append(List.copyOf(owed));
            }
        } catch (IOException | UncheckedIOException e) {
            LOG.log(Level.DEBUG, "the ends of {0} messages are kept in memory: {1}", owed.size(), e.toString());
        }
        return owed.isEmpty();
    }

    private void beginReserve() throws IOException {
        repair();
        if (segment != null) {
            closeSegment();
        }
        segment = reserve.become(FileNames.segment(lastNumber + 1), lastRecords);
        lastNumber++;
        segments++;
        isReserve = true;
    }

    /** Truncates the file to its durable part after a failure, and opens the next segment if necessary. */
    private void prepare() throws IOException {
        repair();
        if (isReserve && !reserve.isFilled()) {
            throw new IOException("no room for new messages");
        }
        if (segment != null && (isReserve || segment.size() > limits.segmentOctets)) {
            closeSegment();
        }
        if (segment == null) {
            openSegment();
        }
    }

    private void repair() throws IOException {
        if (isSuspect) {
            segment.repair();
            isSuspect = false;
        }
    }

    private void openSegment() throws IOException {
        DiskFile file = disk.create(FileNames.segment(lastNumber + 1));
        JournalSegment begun = JournalSegment.begin(file, lastRecords, Long.MAX_VALUE);
        try {
            disk.sync();
        } catch (IOException e) {
            begun.close();
            throw e;
        }
        lastNumber++;
        segments++;
        segment = begun;
    }

    private void closeSegment() throws IOException {
        JournalSegment closing = segment;
        segment = null;
        isReserve = false;
        closedOctets += closing.size();
        lastRecords = closing.records();
        closing.close();
    }

    /** True if {@link #compact} has work to do. */
    public boolean isCompacting() {
        return compaction != null;
    }

    /** Begins a compaction if one is due, or performs its next step; each takes milliseconds. */
    public void compact() {
        try {
            if (compaction == null) {
                beginIfDue();
            } else if (compaction.step()) {
                closedOctets += compaction.size() - replacedOctets;
                compactAboveOctets = limits.minCompactedOctets;
                compaction = null;
            }
        } catch (IOException | UncheckedIOException e) {
            LOG.log(Level.WARNING, "the journal cannot be compacted now: {0}", e.toString());
            compactAboveOctets = octetsOnDisk() + limits.minCompactedOctets;
            if (compaction != null) {
                compaction.abandon();
                compaction = null;
            }
        }
    }

    private void beginIfDue() throws IOException {
        boolean isWasteful = octetsOnDisk() > compactAboveOctets && octetsOnDisk() > limits.mostWaste * state.octets();
        if (!isFailing && (isWasteful || segments > limits.mostSegments)) {
            segments = 0;
            if (segment != null) {
                closeSegment();
            }
            replacedOctets = closedOctets;
            compaction = new Compaction(disk, lastNumber, state.image());
        }
    }

    private long octetsOnDisk() {
        return closedOctets + (segment == null ? 0 : segment.size());
    }

    /** Retries the kept entries, and closes the segment. */
    public void close() {
        if (isFailing) {
            commit(List.of());
        }
        reserve.close();
        if (segment != null) {
            try {
                segment.close();
            } catch (IOException e) {
                LOG.log(Level.DEBUG, "closing the journal: {0}", e.toString());
            }
        }
    }
}
