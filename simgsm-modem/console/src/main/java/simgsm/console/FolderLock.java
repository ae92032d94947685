package simgsm.console;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import simgsm.file.FileErrors;
import simgsm.file.PrivateFiles;

/**
 * A data directory, or a part of it, owned by one process at a time through a file lock that ends with the process.
 */
public final class FolderLock implements AutoCloseable {
    /** One octet beyond any content: a lock on the content would keep this process from reading it on Windows. */
    private static final long LOCKED_OCTET = Long.MAX_VALUE - 1;

    private final Path folder;
    private final String holder;
    private final FileChannel lockFile;
    /** Null until a data file is held. */
    private FileChannel dataFile;

    private FolderLock(Path folder, String holder, FileChannel lockFile) {
        this.folder = folder;
        this.holder = holder;
        this.lockFile = lockFile;
    }

    /**
     * Creates the directory if it is missing, and locks it.
     *
     * @param file the lock file's name
     * @param holder other possible holder, such as "another centre", for the error's text
     * @throws IOException naming the directory if it cannot be made or another process holds it
     */
    public static FolderLock take(Path directory, String file, String holder) throws IOException {
        Path path = directory.toAbsolutePath().normalize();
        try {
            PrivateFiles.makeFolder(path);
        } catch (IOException e) {
            throw new IOException("cannot make the data directory " + FileErrors.describe(e), e);
        }
        return new FolderLock(path, holder, lock(path, path.resolve(file), holder));
    }

    /**
     * Locks a data file, created if missing, instead of the previous one: the lock then holds even if its own file is
     * deleted. Call it after reading or replacing the file, because closing a file ends its locks.
     *
     * @throws IOException naming the directory if another process holds the file
     */
    public void hold(Path file) throws IOException {
        release();
        dataFile = lock(folder, file, holder);
    }

    /** Releases the data file, which Windows can replace only while it is closed; {@link #hold} follows. */
    public void release() throws IOException {
        if (dataFile != null) {
            dataFile.close();
            dataFile = null;
        }
    }

    private static FileChannel lock(Path folder, Path file, String holder) throws IOException {
        FileChannel channel = null;
        boolean isLocked = false;
        try {
            channel = FileErrors.naming(
                    file, () -> PrivateFiles.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE));
            isLocked = channel.tryLock(LOCKED_OCTET, 1, false) != null;
        } catch (OverlappingFileLockException e) {
            // held by this process
        } catch (IOException e) {
            throw new IOException("cannot lock the data directory: " + FileErrors.describe(e), e);
        } finally {
            if (channel != null && !isLocked) {
                channel.close();
            }
        }
        if (!isLocked) {
            throw new IOException(
                    holder + " holds the data directory " + folder + "; expected another one by --data DIR");
        }
        return channel;
    }

    /** Absolute. */
    public Path folder() {
        return folder;
    }

    /** The lock file stays: removing it would let a third process lock a file that a second one is about to open. */
    @Override
    public void close() {
        try {
            lockFile.close();
            if (dataFile != null) {
                dataFile.close();
            }
        } catch (IOException e) {
            // The process is ending, and so is the lock.
        }
    }
}
