package simrobot.editor;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import simrobot.world.Distances;
import simrobot.world.Home;
import simrobot.world.Segment;
import simrobot.world.World;

/** What of a world lies under the pointer. */
public final class Picking {
    private static final double HOME_METERS = 0.3;

    private Picking() {}

    /** The selected item's handle there, the nearest one. */
    public static Optional<Handle> handleAt(World world, Item selected, double x, double y, double reach) {
        return Edits.handles(world, selected).stream()
                .filter(handle -> distance(handle, x, y) <= reach)
                .min(Comparator.comparingDouble(handle -> distance(handle, x, y)));
    }

    private static double distance(Handle handle, double x, double y) {
        return Math.hypot(handle.xMeters() - x, handle.yMeters() - y);
    }

    /** Homes before walls before areas: what is small and lies on top is meant. */
    public static Optional<Item> itemAt(World world, double x, double y, double reach) {
        Item home = home(world, x, y, reach);
        if (home != null) {
            return Optional.of(home);
        }
        Item wall = wall(world.segments(), x, y, reach);
        if (wall != null) {
            return Optional.of(wall);
        }
        return area(world, x, y);
    }

    private static Item home(World world, double x, double y, double reach) {
        for (int i = world.homes().size() - 1; i >= 0; i--) {
            Home home = world.homes().get(i);
            double away =
                    Math.hypot(home.position().xMeters() - x, home.position().yMeters() - y);
            if (away <= Math.max(reach, HOME_METERS)) {
                return new Item(Item.Kind.HOME, i);
            }
        }
        return null;
    }

    private static Item wall(List<Segment> walls, double x, double y, double reach) {
        double nearest = reach;
        Item found = null;
        for (int i = 0; i < walls.size(); i++) {
            Segment w = walls.get(i);
            double away = Distances.toSegment(x, y, w.x1Meters(), w.y1Meters(), w.x2Meters(), w.y2Meters());
            if (away <= nearest) {
                nearest = away;
                found = new Item(Item.Kind.WALL, i);
            }
        }
        return found;
    }

    private static Optional<Item> area(World world, double x, double y) {
        for (int i = world.boxes().size() - 1; i >= 0; i--) {
            if (world.boxes().get(i).area().contains(x, y)) {
                return Optional.of(new Item(Item.Kind.BOX, i));
            }
        }
        for (int i = world.treadmills().size() - 1; i >= 0; i--) {
            if (world.treadmills().get(i).area().contains(x, y)) {
                return Optional.of(new Item(Item.Kind.TREADMILL, i));
            }
        }
        return Optional.empty();
    }
}
