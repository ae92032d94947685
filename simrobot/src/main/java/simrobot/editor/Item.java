package simrobot.editor;

import java.util.Objects;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.WorldItem;

/**
 * A reference to an item of a world.
 *
 * @param index in the world's list of the kind
 */
public record Item(Kind kind, int index) {
    /** What can be edited; points, forbidden lines and areas, and goals cannot. */
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
