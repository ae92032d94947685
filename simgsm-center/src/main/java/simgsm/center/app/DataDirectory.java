package simgsm.center.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import simgsm.console.FolderLock;

/** The directory of messages and subscribers. One process at a time owns it, by a file lock that ends with the process. */
public final class DataDirectory implements AutoCloseable {
    private static final String LOCK_FILE = "lock";
    private static final String OURS = "simgsm";

    private final FolderLock lock;

    private DataDirectory(FolderLock lock) {
        this.lock = lock;
    }

    /**
     * Creates the directory if missing, and locks it.
     *
     * @throws IOException naming the directory if it cannot be created or another process holds it
     */
    static DataDirectory take(Path directory) throws IOException {
        return new DataDirectory(FolderLock.take(directory, LOCK_FILE, "another centre"));
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
        return lock.folder();
    }

    @Override
    public void close() {
        lock.close();
    }
}
