package simrobot.world;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Collects the contents of a world, from scratch or from another world. */
public final class WorldBuilder {
    private final String name;
    private final Map<Class<?>, List<WorldItem>> items = new HashMap<>();

    /** ARIA's usual {@code Resolution: 20}, in metres. */
    private double pointDiameterMeters = 0.02;

    /** An empty world of this name. */
    public WorldBuilder(String name) {
        this.name = name;
    }

    /** Creates a builder with a world's contents under another name. */
    public WorldBuilder(World world, String name) {
        this(name);
        world.items().forEach(this::add);
        pointDiameterMeters = world.pointDiameterMeters();
    }

    /** Adds an item after the others of its type. */
    public WorldBuilder add(WorldItem item) {
        list(item.getClass()).add(item);
        return this;
    }

    /** Sets the diameter of all points. */
    public WorldBuilder pointDiameter(double meters) {
        pointDiameterMeters = meters;
        return this;
    }

    /**
     * Replaces an item by another of its type.
     *
     * @param index among the items of the type
     */
    public WorldBuilder set(int index, WorldItem item) {
        list(item.getClass()).set(index, item);
        return this;
    }

    /** Removes an item. @param index among the items of the type */
    public WorldBuilder remove(Class<? extends WorldItem> type, int index) {
        list(type).remove(index);
        return this;
    }

    private List<WorldItem> list(Class<? extends WorldItem> type) {
        return items.computeIfAbsent(type, first -> new ArrayList<>());
    }

    public World build() {
        return new World(name, pointDiameterMeters, items);
    }
}
