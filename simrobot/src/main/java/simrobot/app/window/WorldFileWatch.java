package simrobot.app.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;

/** Detects changes of the world's file by other programs; checks every 2 s. */
final class WorldFileWatch {
    private static final long PERIOD_NANOS = TimeUnit.SECONDS.toNanos(2);

    private final Executor disk;
    private volatile Path file;
    private volatile Optional<FileTime> known;
    private volatile boolean changed;
    private long lookedNanos = System.nanoTime();

    /** @param disk performs the file access */
    WorldFileWatch(Executor disk, Path file) {
        this.disk = disk;
        this.file = file;
        known = time(file);
    }

    /** Declares the file's current content to be the simulation's world. */
    void setCurrent(Path newFile) {
        file = newFile;
        known = time(newFile);
        changed = false;
    }

    /** The result of the last check; starts a new one when due. For one thread. */
    boolean hasChanged() {
        long now = System.nanoTime();
        if (now - lookedNanos > PERIOD_NANOS) {
            lookedNanos = now;
            disk.execute(this::look);
        }
        return changed;
    }

    /** A file that is missing, or was missing before, has not changed. */
    void look() {
        Optional<FileTime> time = time(file);
        changed = known.isPresent() && time.isPresent() && !time.equals(known);
    }

    private static Optional<FileTime> time(Path file) {
        try {
            return Optional.of(Files.getLastModifiedTime(file));
        } catch (IOException gone) {
            return Optional.empty();
        }
    }
}
