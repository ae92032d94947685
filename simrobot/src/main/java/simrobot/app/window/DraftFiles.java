package simrobot.app.window;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Executor;
import simrobot.world.MapWriter;
import simrobot.world.World;

/** Copies of unsaved drafts on the disk. A copy whose draft is dropped before the write is not written. */
final class DraftFiles {
    private static final Logger LOG = System.getLogger(DraftFiles.class.getName());

    /** Number of drops. */
    private long drops;

    /** Writes a copy on the worker's thread. */
    void keep(World draft, Path file, Executor worker) {
        long before = drops();
        worker.execute(() -> write(draft, file, before));
    }

    private synchronized long drops() {
        return drops;
    }

    private synchronized void write(World draft, Path file, long before) {
        if (drops != before) {
            return;
        }
        try {
            MapWriter.save(draft, file);
        } catch (IOException unwritable) {
            LOG.log(Level.DEBUG, "no copy of the draft: " + unwritable.getMessage());
        }
    }

    /** Deletes the copy, if there is one, and cancels waiting ones. */
    synchronized void drop(Path file) {
        drops++;
        try {
            Files.deleteIfExists(file);
        } catch (IOException stays) {
            // the next draft of this file replaces it
        }
    }
}
