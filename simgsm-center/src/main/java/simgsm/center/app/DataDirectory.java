package simgsm.center.app;

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
import java.util.Map;
import java.util.Optional;
import java.util.Properties;

/** The directory of messages and subscribers. One process at a time owns it, by a file lock that ends with the process. */
public final class DataDirectory implements AutoCloseable {
    private static final String LOCK_FILE = "lock";
    private static final String OURS = "simgsm";

    private final Path path;
    private final FileChannel channel;
    private final FileLock lock;

    private DataDirectory(Path path, FileChannel channel, FileLock lock) {
        this.path = path;
        this.channel = channel;
        this.lock = lock;
    }

    /**
     * Creates the directory if it is missing, and locks it.
     *
     * @throws IOException naming the directory if it cannot be made or another process holds it
     */
    static DataDirectory take(Path directory) throws IOException {
        Path path = directory.toAbsolutePath().normalize();
        try {
            Files.createDirectories(path);
        } catch (IOException e) {
            throw new IOException("cannot make the data directory " + path + ": " + reason(e), e);
        }
        FileChannel channel = open(path);
        FileLock lock = tryLock(channel);
        if (lock == null) {
            channel.close();
            throw new IOException("another centre holds the data directory " + path);
        }
        return new DataDirectory(path, channel, lock);
    }

    private static FileChannel open(Path path) throws IOException {
        try {
            return FileChannel.open(path.resolve(LOCK_FILE), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
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

    /** {@code $XDG_DATA_HOME/simgsm} if that is set to an absolute path, else the platform's usual directory. */
    public static Path defaultPath(Map<String, String> environment, Properties system) {
        Optional<Path> xdg = absolute(environment.get("XDG_DATA_HOME"));
        if (xdg.isPresent()) {
            return xdg.get().resolve(OURS);
        }
        Path home = Path.of(system.getProperty("user.home"));
        String os = system.getProperty("os.name", "");
        if (os.startsWith("Windows")) {
            return absolute(environment.get("LOCALAPPDATA"))
                    .orElse(home.resolve("AppData").resolve("Local"))
                    .resolve(OURS);
        }
        return os.startsWith("Mac")
                ? home.resolve("Library").resolve("Application Support").resolve(OURS)
                : home.resolve(".local").resolve("share").resolve(OURS);
    }

    private static Optional<Path> absolute(String text) {
        return Optional.ofNullable(text).map(Path::of).filter(Path::isAbsolute);
    }

    Path path() {
        return path;
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
