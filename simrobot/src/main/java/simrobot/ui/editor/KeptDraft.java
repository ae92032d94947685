package simrobot.ui.editor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import simrobot.ui.OperatorActions;
import simrobot.world.World;
import simrobot.world.WorldReader;

/**
 * The copy of an unsaved draft on the disk, {@code .NAME.draft} next to the world's file. It is written 0.2 s after a
 * change and deleted when the draft is saved or dropped; after the end of the process, the editor offers it at the next
 * opening of the file.
 */
final class KeptDraft {
    private final OperatorActions operator;
    private World written;

    KeptDraft(OperatorActions operator) {
        this.operator = operator;
    }

    static Path placeOf(Path file) {
        return file.resolveSibling("." + file.getFileName() + ".draft");
    }

    /** Writes the draft, if it differs from the last written one. */
    void keep(World draft, Path file) {
        if (draft != written) {
            written = draft;
            operator.keep(draft, placeOf(file));
        }
    }

    /** The draft of an editor that ended without saving; empty without one, or if its file is damaged. */
    static Optional<World> of(Path file) {
        Path kept = placeOf(file);
        if (!Files.isRegularFile(kept)) {
            return Optional.empty();
        }
        try {
            return Optional.of(WorldReader.read(kept).named(String.valueOf(file.getFileName())));
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }

    void drop(Path file) {
        written = null;
        operator.dropKept(placeOf(file));
    }
}
