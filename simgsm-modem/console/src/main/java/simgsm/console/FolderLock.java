package simgsm.console;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

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
            Files.createDirectories(path);
        } catch (IOException e) {
            throw new IOException("cannot make the data directory " + path + ": " + reason(e), e);
        }
        FileChannel channel = open(path, file);
        FileLock lock = tryLock(channel);
        if (lock == null) {
            channel.close();
            throw new IOException(holder + " holds the data directory " + path);
        }
        return new FolderLock(path, channel, lock);
    }

    private static FileChannel open(Path path, String file) throws IOException {
        try {
            return FileChannel.open(path.resolve(file), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        } catch (IOException e) {
            throw new IOException("cannot write in the data directory " + path + ": " + reason(e), e);
        }
    }

    /** A reason in words, where the exception's message is only the path. */
    private static String reason(IOException e) {
        if (e instanceof FileAlreadyExistsException) {
            return "there is a file of that name";
        }
        if (e instanceof AccessDeniedException) {
            return "access denied";
        }
        return e instanceof NoSuchFileException ? "no such folder" : e.getMessage();
    }

    private static FileLock tryLock(FileChannel channel) throws IOException {
        try {
            return channel.tryLock();
        } catch (OverlappingFileLockException e) {
            return null;
        }
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
