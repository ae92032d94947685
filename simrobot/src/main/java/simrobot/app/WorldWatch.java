package simrobot.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;

/** Notices that the present world's file has been changed by another program. */
final class WorldWatch {
    private static final long PERIOD_NANOS = TimeUnit.SECONDS.toNanos(2);

    private final Executor disk;
    private volatile Path file;
    private volatile Optional<FileTime> known;
    private volatile boolean changed;
    private long lookedNanos = System.nanoTime();

    /** @param disk where the file is looked at */
    WorldWatch(Executor disk, Path file) {
        this.disk = disk;
        this.file = file;
        known = time(file);
    }

    /** As the file is now it is what the robots have. */
    void isUpToDate(Path newFile) {
        file = newFile;
        known = time(newFile);
        changed = false;
    }

    /** Told at once what was seen last; now and then has it looked at anew. For one thread. */
    boolean hasChanged() {
        long now = System.nanoTime();
        if (now - lookedNanos > PERIOD_NANOS) {
            lookedNanos = now;
            disk.execute(this::look);
        }
        return changed;
    }

    /** A file that is gone, or was not there, has not changed. */
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
