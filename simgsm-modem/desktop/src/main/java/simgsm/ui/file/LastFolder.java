package simgsm.ui.file;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The folder of the last chosen file, shared by all dialogs of a program; owned by the event thread. */
public final class LastFolder {
    private static Optional<Path> folder = Optional.empty();

    private LastFolder() {}

    /** The folder; empty if no file was chosen or the folder no longer exists. */
    public static Optional<Path> get() {
        return folder.filter(Files::isDirectory);
    }

    /** Sets the folder shown by the next dialog. */
    public static void set(Path shown) {
        folder = Optional.of(shown.toAbsolutePath());
    }

    static void keepOf(Path file) {
        Optional.ofNullable(file.toAbsolutePath().getParent()).ifPresent(LastFolder::set);
    }
}
