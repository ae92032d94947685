package simgsm.ui.file;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The folder of the file that was chosen last, one for all dialogs of a program; belongs to the event thread. */
public final class LastFolder {
    private static Optional<Path> folder = Optional.empty();

    private LastFolder() {}

    /** The folder; empty if no file was chosen, or if the folder is gone. */
    public static Optional<Path> get() {
        return folder.filter(Files::isDirectory);
    }

    /** Sets the folder that the next dialog shows. */
    public static void set(Path shown) {
        folder = Optional.of(shown.toAbsolutePath());
    }

    static void keepOf(Path file) {
        Optional.ofNullable(file.toAbsolutePath().getParent()).ifPresent(LastFolder::set);
    }
}
