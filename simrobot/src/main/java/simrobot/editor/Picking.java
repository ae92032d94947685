package simrobot.editor;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simrobot.world.AreaItem;
import simrobot.world.Distances;
import simrobot.world.ItemKind;
import simrobot.world.ItemKinds;
import simrobot.world.Position;
import simrobot.world.World;

/** Finds the items and handles at a position. */
public final class Picking {
    private static final double PLACE_METERS = 0.3;

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

    /**
     * The item at a position: homes before walls, walls before areas; the last of homes and areas, the nearest of
     * walls.
     */
    public static Optional<Item> itemAt(World world, double x, double y, double reach) {
        double placeReach = Math.max(reach, PLACE_METERS);
        return lastFirst(world, ItemKind.Shape.PLACE)
                .filter(item -> distance(outline(world, item).get(0), x, y) <= placeReach)
                .findFirst()
                .or(() -> lastFirst(world, ItemKind.Shape.LINE)
                        .filter(item -> away(world, item, x, y) <= reach)
                        .min(Comparator.comparingDouble(item -> away(world, item, x, y))))
                .or(() -> lastFirst(world, ItemKind.Shape.AREA)
                        .filter(item ->
                                ((AreaItem) Edits.get(world, item)).area().contains(x, y))
                        .findFirst());
    }

    /** The items of this shape, by their kinds, the last of each kind first. */
    private static Stream<Item> lastFirst(World world, ItemKind.Shape shape) {
        return ItemKinds.edited().filter(kind -> kind.shape() == shape).flatMap(kind -> {
            int count = Edits.count(world, kind);
            return IntStream.rangeClosed(1, count).mapToObj(i -> new Item(kind, count - i));
        });
    }

    private static List<Position> outline(World world, Item item) {
        return Edits.get(world, item).outline();
    }

    private static double away(World world, Item line, double x, double y) {
        Position from = outline(world, line).get(0);
        Position to = outline(world, line).get(1);
        return Distances.toSegment(x, y, from.xMeters(), from.yMeters(), to.xMeters(), to.yMeters());
    }
}
