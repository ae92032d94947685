package simgsm.center.journal;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import simgsm.center.smsc.StoreEntry;

/** Writes a ledger's image into a snapshot, a little at a time, and then deletes what the snapshot stands for. */
final class Compaction {
    private static final System.Logger LOG = System.getLogger(Journal.class.getName());

    /** Entries a step: a few milliseconds. */
    private static final int STEP_ENTRIES = 1_000;

    private final Disk disk;
    private final long number;
    private final Iterator<StoreEntry> rest;
    private final JournalSegment snapshot;

    /**
     * @param number of the last segment that is not written to any more
     * @param image what everything up to that segment amounts to
     */
    Compaction(Disk disk, long number, List<StoreEntry> image) throws IOException {
        this.disk = disk;
        this.number = number;
        this.rest = image.iterator();
        this.snapshot = new JournalSegment(disk.create(FileNames.unfinished()));
    }

    /** @return whether the snapshot is complete and in force */
    boolean step() throws IOException {
        List<StoreEntry> next = new ArrayList<>(STEP_ENTRIES);
        while (rest.hasNext() && next.size() < STEP_ENTRIES) {
            next.add(rest.next());
        }
        snapshot.append(next);
        if (rest.hasNext()) {
            return false;
        }
        snapshot.close();
        disk.rename(FileNames.unfinished(), FileNames.snapshot(number));
        disk.sync();
        removeSuperseded();
        return true;
    }

    long size() {
        return snapshot.size();
    }

    /** What stays by mischance does no harm: the next start passes over it. */
    private void removeSuperseded() {
        try {
            for (String name : disk.names()) {
                if (FileNames.isSuperseded(name, number)) {
                    disk.delete(name);
                }
            }
        } catch (IOException e) {
            LOG.log(Level.WARNING, "an old part of the journal cannot be deleted: {0}", e.toString());
        }
    }

    /** Gives up; what is written so far does not count. */
    void abandon() {
        try {
            snapshot.close();
            disk.delete(FileNames.unfinished());
        } catch (IOException e) {
            // The next compaction writes over it, and so does the next start.
        }
    }
}
