package simrobot.editor;

import java.util.Objects;

/**
 * One thing in a world that can be edited.
 *
 * @param index in the world's list of that kind
 */
public record Item(Kind kind, int index) {
    /** What can be edited; points of scans and what binds planners only stay as they are. */
    public enum Kind {
        WALL,
        BOX,
        HOME,
        TREADMILL
    }

    public Item {
        Objects.requireNonNull(kind);
        if (index < 0) {
            throw new IllegalArgumentException("item " + index + ", expected 0 or more");
        }
    }
}
