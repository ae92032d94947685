package simgsm.center.journal;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import simgsm.center.smsc.StoreEntry;

/**
 * Writes the journal's state to a snapshot, in steps, verifies it, renames it, and finally deletes the replaced files.
 */
final class Compaction {
    private static final System.Logger LOG = System.getLogger(Journal.class.getName());

    /** Entries per step; a few milliseconds. */
    private static final int STEP_ENTRIES = 1_000;

    private final Disk disk;
    private final long number;
    private final Iterator<StoreEntry> rest;
    private final JournalSegment snapshot;
    /** Null until everything is written. */
    private SnapshotProof proof;

    /**
     * @param number of the last closed segment
     * @param image the state after that segment
     */
    Compaction(Disk disk, long number, Iterator<StoreEntry> image) throws IOException {
        this.disk = disk;
        this.number = number;
        this.rest = image;
        this.snapshot = JournalSegment.begin(disk.create(FileNames.unfinished()), 0, Long.MAX_VALUE);
    }

    /**
     * Writes or verifies the next entries.
     *
     * @return true once the snapshot has replaced the older files
     */
    boolean step() throws IOException {
        if (rest.hasNext()) {
            writeNext();
            return false;
        }
        if (proof == null) {
            snapshot.append(new FileMark.Closed(snapshot.records()));
            snapshot.close();
            proof = new SnapshotProof(FileNames.unfinished(), disk.open(FileNames.unfinished()));
        }
        if (!proof.read(STEP_ENTRIES)) {
            return false;
        }
        finish();
        return true;
    }

    private void writeNext() throws IOException {
        List<StoreEntry> next = new ArrayList<>(STEP_ENTRIES);
        while (rest.hasNext() && next.size() < STEP_ENTRIES) {
            next.add(rest.next());
        }
        snapshot.append(next, false);
    }

    private void finish() throws IOException {
        proof.close();
        if (!proof.isWhole()) {
            throw new IOException("the snapshot does not read back as it was written");
        }
        disk.rename(FileNames.unfinished(), FileNames.snapshot(number));
        disk.sync();
        removeSuperseded();
    }

    long size() {
        return snapshot.size();
    }

    /** the next start ignores a file that cannot be deleted */
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
            if (proof != null) {
                proof.close();
            }
            disk.delete(FileNames.unfinished());
        } catch (IOException | UncheckedIOException e) {
            // the next compaction overwrites it; the next start deletes it
        }
    }
}
