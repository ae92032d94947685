package simrobot.ui.editor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import simrobot.ui.OperatorActions;
import simrobot.world.World;
import simrobot.world.WorldReader;

/**
 * The copy of an unsaved draft on the disk, {@code .NAME.draft} beside the world's file. It is there from 0.2 s after a change
 * until the draft is saved or dropped; where the process ends in between, the editor offers it when it opens that file next.
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

    /** Writes the draft, if it differs from the one written last. */
    void keep(World draft, Path file) {
        if (draft != written) {
            written = draft;
            operator.keep(draft, placeOf(file));
        }
    }

    /** The draft of an editor that ended without saving; empty without one, or where its file is damaged. */
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
