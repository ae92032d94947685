package simrobot.editor;

import java.util.Objects;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.WorldItem;

/**
 * One thing in a world that can be edited.
 *
 * @param index in the world's list of that kind
 */
public record Item(Kind kind, int index) {
    /** What can be edited; points of scans and what binds planners only stay as they are. */
    public enum Kind {
        WALL(Segment.class),
        BOX(Box.class),
        HOME(Home.class),
        TREADMILL(Treadmill.class);

        private final Class<? extends WorldItem> type;

        Kind(Class<? extends WorldItem> type) {
            this.type = type;
        }

        Class<? extends WorldItem> type() {
            return type;
        }
    }

    public Item {
        Objects.requireNonNull(kind);
        if (index < 0) {
            throw new IllegalArgumentException("item " + index + ", expected 0 or more");
        }
    }
}
