package simgsm.center.journal;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import simgsm.center.smsc.Restored;
import simgsm.center.smsc.StoreEntry;

/**
 * The store on disk: entries appended to segments, each group durable before it counts, and now and then a snapshot in
 * place of all segments before it. Knows no thread and no clock; one owner drives it.
 *
 * <p>What does not get onto the disk is refused; but of what has happened already, and so cannot be refused, it keeps a
 * memory, and writes it first when the disk works again.
 */
public final class Journal {
    private static final System.Logger LOG = System.getLogger(Journal.class.getName());

    /** Below this it is not worth the trouble. */
    private static final long MIN_COMPACTED_OCTETS = 4 << 20;
    /** A segment that has grown so large is followed by the next. */
    private static final long SEGMENT_OCTETS = 16 << 20;
    /** So many times what is needed may lie on the disk. */
    private static final int MOST_WASTE = 3;

    private static final int MOST_SEGMENTS = 32;

    private final Disk disk;
    private final long minCompactedOctets;
    private final Ledger ledger;
    /** In order; what is asked for again is owed once. */
    private final Set<StoreEntry> owed = new LinkedHashSet<>();

    private JournalSegment segment;
    /** The segment may hold more than is certain. */
    private boolean isSuspect;

    private boolean isFailing;
    private Compaction compaction;
    private long lastNumber;
    /** In files that are not written to any more; of these, what the compaction under way is to replace. */
    private long closedOctets;

    private long replacedOctets;
    private int segments;
    private long compactAboveOctets;

    private Journal(Disk disk, long minCompactedOctets, int maxRecent) {
        this.disk = disk;
        this.ledger = new Ledger(maxRecent);
        this.minCompactedOctets = minCompactedOctets;
        this.compactAboveOctets = minCompactedOctets;
    }

    /**
     * Reads what is there; damage is logged by file and position, and the rest saved.
     *
     * @throws IOException if the disk cannot be read
     */
    public static Journal open(Disk disk) throws IOException {
        return open(disk, MIN_COMPACTED_OCTETS, Ledger.MAX_RECENT);
    }

    /** With limits so small that a test reaches them. */
    static Journal open(Disk disk, long minCompactedOctets, int maxRecent) throws IOException {
        Journal journal = new Journal(disk, minCompactedOctets, maxRecent);
        Recovery recovery = new Recovery(disk, journal.ledger);
        recovery.run();
        journal.lastNumber = recovery.lastNumber();
        journal.closedOctets = recovery.octets();
        journal.segments = recovery.segments();
        return journal;
    }

    /** What the entries so far amount to. */
    public Restored restored() {
        return ledger.restored();
    }

    /** Makes entries durable, all or none. @return whether they are */
    public boolean commit(List<StoreEntry> entries) {
        List<StoreEntry> all = new ArrayList<>(owed.size() + entries.size());
        all.addAll(owed);
        all.addAll(entries);
        try {
            prepare();
            isSuspect = true;
            segment.append(all);
            isSuspect = false;
        } catch (IOException e) {
            failed(entries, e);
            return false;
        }
        if (isFailing) {
            LOG.log(Level.WARNING, "the disk takes the journal again");
            isFailing = false;
            owed.clear();
        }
        all.forEach(ledger::apply);
        return true;
    }

    /** Whether the disk has refused the last commit; an empty commit tries again to write what has happened since. */
    public boolean isFailing() {
        return isFailing;
    }

    private void failed(List<StoreEntry> refused, IOException e) {
        LOG.log(isFailing ? Level.DEBUG : Level.ERROR, "the disk does not take the journal: {0}", e.toString());
        isFailing = true;
        for (StoreEntry entry : refused) {
            if (!(entry instanceof StoreEntry.Accepted)) {
                owed.add(entry);
            }
        }
    }

    /** After a failure nobody knows what the file holds, so it is cut to what is certain. */
    private void prepare() throws IOException {
        if (isSuspect) {
            segment.repair();
            isSuspect = false;
        }
        if (segment != null && segment.size() > SEGMENT_OCTETS) {
            closeSegment();
        }
        if (segment == null) {
            openSegment();
        }
    }

    private void openSegment() throws IOException {
        DiskFile file = disk.create(FileNames.segment(lastNumber + 1));
        try {
            disk.sync();
        } catch (IOException e) {
            file.close();
            throw e;
        }
        lastNumber++;
        segments++;
        segment = new JournalSegment(file);
    }

    private void closeSegment() throws IOException {
        JournalSegment closing = segment;
        segment = null;
        closedOctets += closing.size();
        closing.close();
    }

    /** Whether {@link #compact} has work to do. */
    public boolean isCompacting() {
        return compaction != null;
    }

    /** Begins a compaction if too much on the disk is dead, or does the next step of one; each takes milliseconds. */
    public void compact() {
        try {
            if (compaction == null) {
                beginIfDue();
            } else if (compaction.step()) {
                closedOctets += compaction.size() - replacedOctets;
                compactAboveOctets = minCompactedOctets;
                compaction = null;
            }
        } catch (IOException e) {
            LOG.log(Level.WARNING, "the journal cannot be compacted now: {0}", e.toString());
            compactAboveOctets = octetsOnDisk() + minCompactedOctets;
            if (compaction != null) {
                compaction.abandon();
                compaction = null;
            }
        }
    }

    private void beginIfDue() throws IOException {
        boolean isWasteful = octetsOnDisk() > compactAboveOctets && octetsOnDisk() > MOST_WASTE * ledger.octets();
        if (!isFailing && (isWasteful || segments > MOST_SEGMENTS)) {
            segments = 0;
            if (segment != null) {
                closeSegment();
            }
            replacedOctets = closedOctets;
            compaction = new Compaction(disk, lastNumber, ledger.image());
        }
    }

    private long octetsOnDisk() {
        return closedOctets + (segment == null ? 0 : segment.size());
    }

    /** Tries once more to write what is owed, and ends. */
    public void close() {
        if (isFailing) {
            commit(List.of());
        }
        if (segment != null) {
            try {
                segment.close();
            } catch (IOException e) {
                LOG.log(Level.DEBUG, "closing the journal: {0}", e.toString());
            }
        }
    }
}
