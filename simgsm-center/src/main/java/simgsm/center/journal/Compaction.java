package simgsm.center.journal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import simgsm.center.smsc.StoreEntry;

/** Writes the journal's state into a snapshot, in steps, and then deletes the files that the snapshot replaces. */
final class Compaction {
    private static final System.Logger LOG = System.getLogger(Journal.class.getName());

    /** Entries per step; a few milliseconds. */
    private static final int STEP_ENTRIES = 1_000;

    private final Disk disk;
    private final long number;
    private final Iterator<StoreEntry> rest;
    private final JournalSegment snapshot;

    /**
     * @param number of the last closed segment
     * @param image the state after that segment
     */
    Compaction(Disk disk, long number, List<StoreEntry> image) throws IOException {
        this.disk = disk;
        this.number = number;
        this.rest = image.iterator();
        this.snapshot = new JournalSegment(disk.create(FileNames.unfinished()));
    }

    /** Writes the next entries. @return whether the snapshot is complete and has replaced the older files */
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

    /** A file that cannot be deleted is ignored by the next start. */
    private void removeSuperseded() {
        try {
            for (String name : disk.names()) {
                if (FileNames.isSuperseded(name, number)) {
                    disk.delete(name);
                }
            }
        } catch (IOException | UncheckedIOException e) {
            LOG.log(Level.WARNING, "an old part of the journal cannot be deleted: {0}", e.toString());
        }
    }

    /** Deletes the unfinished snapshot. */
    void abandon() {
        try {
            snapshot.close();
            disk.delete(FileNames.unfinished());
        } catch (IOException | UncheckedIOException e) {
            // The next compaction overwrites it; the next start deletes it.
        }
    }
}
