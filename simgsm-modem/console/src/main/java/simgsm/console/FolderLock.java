package simgsm.console;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import simgsm.file.FileErrors;
import simgsm.file.PrivateFiles;

/** A data directory, or a part of it, that one process at a time owns, by a file lock that ends with the process. */
public final class FolderLock implements AutoCloseable {
    private final Path folder;
    private final FileChannel channel;
    private final FileLock lock;

    private FolderLock(Path folder, FileChannel channel, FileLock lock) {
        this.folder = folder;
        this.channel = channel;
        this.lock = lock;
    }

    /**
     * Creates the directory if it is missing, and locks it.
     *
     * @param file the lock file's name
     * @param holder who else may hold it, such as "another centre", for the error's text
     * @throws IOException naming the directory if it cannot be made or another process holds it
     */
    public static FolderLock take(Path directory, String file, String holder) throws IOException {
        Path path = directory.toAbsolutePath().normalize();
        try {
            PrivateFiles.makeFolder(path);
        } catch (IOException e) {
            throw new IOException("cannot make the data directory " + FileErrors.describe(e), e);
        }
        Path lockFile = path.resolve(file);
        try {
            return FileErrors.naming(lockFile, () -> lock(path, lockFile));
        } catch (OverlappingFileLockException e) {
            throw new IOException(
                    holder + " holds the data directory " + path + "; expected another one by --data DIR", e);
        } catch (IOException e) {
            throw new IOException("cannot lock the data directory: " + FileErrors.describe(e), e);
        }
    }

    /** @throws OverlappingFileLockException if another process, or this one, holds the lock */
    private static FolderLock lock(Path path, Path lockFile) throws IOException {
        FileChannel channel = PrivateFiles.open(lockFile, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        FileLock lock = null;
        try {
            lock = channel.tryLock();
        } finally {
            if (lock == null) {
                channel.close();
            }
        }
        if (lock == null) {
            throw new OverlappingFileLockException();
        }
        return new FolderLock(path, channel, lock);
    }

    /** Absolute. */
    public Path folder() {
        return folder;
    }

    /** The lock file stays: removing it would let a third process lock a file that a second one is about to open. */
    @Override
    public void close() {
        try {
            lock.release();
            channel.close();
        } catch (IOException e) {
            // The process is ending, and the lock with it.
        }
    }
}
