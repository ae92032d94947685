package simrobot.world;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;

/** The floor and its items: one list, by kinds and within a kind in the file's order; immutable. */
public final class World {
    /** Half the side of an empty world. */
    private static final double BARE_FLOOR_METERS = 10;

    /** Width of two robots side by side. */
    private static final double ROOM_METERS = 1;

    private final String name;
    private final double pointDiameterMeters;

    /** The items of each present type, in the order of {@link ItemKinds#ALL}. */
    private final Map<Class<?>, List<? extends WorldItem>> items = new LinkedHashMap<>();

    /**
     * @param name for titles: the file's name without folder
     * @param pointDiameterMeters diameter of each {@link Point} to a single ray
     */
    World(String name, double pointDiameterMeters, Map<Class<?>, List<WorldItem>> contents) {
        this.name = name;
        this.pointDiameterMeters = pointDiameterMeters;
        if (!(pointDiameterMeters >= 0)) {
            throw new IllegalArgumentException("a point's diameter is " + pointDiameterMeters + ", expected 0 or more");
        }
        for (ItemKind<?> kind : ItemKinds.ALL) {
            List<WorldItem> ofKind = contents.getOrDefault(kind.type(), List.of());
            if (!ofKind.isEmpty()) {
                items.put(kind.type(), List.copyOf(ofKind));
            }
        }
    }

    /** An empty world. */
    public static World bare() {
        return of("bare", List.of());
    }

    /** A world of these items. */
    public static World of(String name, List<? extends WorldItem> items) {
        WorldBuilder builder = new WorldBuilder(name);
        items.forEach(builder::add);
        return builder.build();
    }

    public World named(String newName) {
        return new WorldBuilder(this, newName).build();
    }

    /** A builder with the contents of this world. */
    public WorldBuilder toBuilder() {
        return new WorldBuilder(this, name);
    }

    public String name() {
        return name;
    }

    public double pointDiameterMeters() {
        return pointDiameterMeters;
    }

    /** All items, by their kinds. */
    public Stream<WorldItem> items() {
        return items.values().stream().flatMap(List::stream);
    }

    /** The items of a type, in the file's order. */
    @SuppressWarnings("unchecked")
    public <T extends WorldItem> List<T> items(Class<T> type) {
        return (List<T>) items.getOrDefault(type, List.of());
    }

    /** Every straight obstacle: walls, then the sides of the boxes. */
    public List<Segment> obstacles() {
        List<Segment> all = new ArrayList<>();
        items().forEach(item -> all.addAll(item.obstacles()));
        return all;
    }

    /** The parts of the floor that act on wheels. */
    public List<Surface> surfaces() {
        return items().filter(Surface.class::isInstance)
                .map(Surface.class::cast)
                .toList();
    }

    /** The smallest upright rectangle around all items. */
    public Area bounds() {
        BoundingBox bounds = new BoundingBox();
        items().forEach(bounds::add);
        return bounds.or(new Area(-BARE_FLOOR_METERS, -BARE_FLOOR_METERS, BARE_FLOOR_METERS, BARE_FLOOR_METERS, 0));
    }

    /**
     * The area for robots: the bounds, or, for a world less than 1 m wide or deep such as a single wall, 20 m of floor
     * around its middle.
     */
    public Area ground() {
        Area bounds = bounds();
        boolean encloses =
                Math.min(bounds.maxXMeters() - bounds.minXMeters(), bounds.maxYMeters() - bounds.minYMeters())
                        >= ROOM_METERS;
        if (encloses) {
            return bounds;
        }
        Position middle = bounds.center();
        return new Area(
                Math.min(bounds.minXMeters(), middle.xMeters() - BARE_FLOOR_METERS),
                Math.min(bounds.minYMeters(), middle.yMeters() - BARE_FLOOR_METERS),
                Math.max(bounds.maxXMeters(), middle.xMeters() + BARE_FLOOR_METERS),
                Math.max(bounds.maxYMeters(), middle.yMeters() + BARE_FLOOR_METERS),
                0);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof World world
                && name.equals(world.name)
                && pointDiameterMeters == world.pointDiameterMeters
                && items.equals(world.items);
    }

    @Override
    public int hashCode() {
        return Objects.hash(name, items);
    }

    @Override
    public String toString() {
        return "World " + name + " " + items;
    }
}
