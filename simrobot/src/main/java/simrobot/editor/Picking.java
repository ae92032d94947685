package simrobot.editor;

import java.util.Comparator;
import java.util.Optional;
import java.util.function.Predicate;
import simrobot.world.Box;
import simrobot.world.Distances;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;
import simrobot.world.WorldItem;

/** Finds the items and handles at a place. */
public final class Picking {
    private static final double HOME_METERS = 0.3;

    private Picking() {}

    /** The nearest handle of the item within the reach, in metres. */
    public static Optional<Handle> handleAt(World world, Item item, double x, double y, double reach) {
        return Edits.handles(world, item).stream()
                .filter(handle -> distance(handle.place(), x, y) <= reach)
                .min(Comparator.comparingDouble(handle -> distance(handle.place(), x, y)));
    }

    private static double distance(Position place, double x, double y) {
        return Math.hypot(place.xMeters() - x, place.yMeters() - y);
    }

    /** A home before a wall, a wall before an area; of homes and areas the last, of walls the nearest. */
    public static Optional<Item> itemAt(World world, double x, double y, double reach) {
        double homeReach = Math.max(reach, HOME_METERS);
        return last(world, Item.Kind.HOME, item -> distance(((Home) item).position(), x, y) <= homeReach)
                .or(() -> wall(world, x, y, reach))
                .or(() -> last(world, Item.Kind.BOX, item -> ((Box) item).area().contains(x, y)))
                .or(() -> last(
                        world,
                        Item.Kind.TREADMILL,
                        item -> ((Treadmill) item).area().contains(x, y)));
    }

    private static Optional<Item> last(World world, Item.Kind kind, Predicate<WorldItem> isThere) {
        for (int i = Edits.count(world, kind) - 1; i >= 0; i--) {
            Item item = new Item(kind, i);
            if (isThere.test(Edits.get(world, item))) {
                return Optional.of(item);
            }
        }
        return Optional.empty();
    }

    private static Optional<Item> wall(World world, double x, double y, double reach) {
        double nearest = reach;
        Item found = null;
        for (int i = 0; i < world.segments().size(); i++) {
            Segment w = world.segments().get(i);
            double away = Distances.toSegment(x, y, w.x1Meters(), w.y1Meters(), w.x2Meters(), w.y2Meters());
            if (away <= nearest) {
                nearest = away;
                found = new Item(Item.Kind.WALL, i);
            }
        }
        return Optional.ofNullable(found);
    }
}
