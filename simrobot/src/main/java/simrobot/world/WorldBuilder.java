package simrobot.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Collects the contents of a world, from nothing or from another world. */
public final class WorldBuilder {
    final List<Segment> segments = new ArrayList<>();
    final List<Position> points = new ArrayList<>();
    final List<Box> boxes = new ArrayList<>();
    final List<Home> homes = new ArrayList<>();
    final List<Segment> forbiddenLines = new ArrayList<>();
    final List<Area> forbiddenAreas = new ArrayList<>();
    final List<Treadmill> treadmills = new ArrayList<>();
    final List<Goal> goals = new ArrayList<>();
    private final Map<Class<? extends WorldItem>, List<? extends WorldItem>> items =
            Map.of(Segment.class, segments, Box.class, boxes, Home.class, homes, Treadmill.class, treadmills);

    /** ARIA's usual {@code Resolution: 20}, in metres. */
    double pointDiameterMeters = 0.02;

    private final String name;

    /** An empty world of this name. */
    public WorldBuilder(String name) {
        this.name = name;
    }

    /** All that a world holds, under another name. */
    public WorldBuilder(World world, String name) {
        this(name);
        segments.addAll(world.segments());
        points.addAll(world.points());
        boxes.addAll(world.boxes());
        homes.addAll(world.homes());
        forbiddenLines.addAll(world.forbiddenLines());
        forbiddenAreas.addAll(world.forbiddenAreas());
        treadmills.addAll(world.treadmills());
        goals.addAll(world.goals());
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

    public WorldBuilder addPoint(Position point) {
        points.add(point);
        return this;
    }

    public WorldBuilder addGoal(Goal goal) {
        goals.add(goal);
        return this;
    }

    public WorldBuilder addForbidden(Segment line) {
        forbiddenLines.add(line);
        return this;
    }

    public WorldBuilder addForbidden(Area area) {
        forbiddenAreas.add(area);
        return this;
    }

    /** Puts an item in the place of another of its type. @param index among the items of the type */
    public WorldBuilder set(int index, WorldItem item) {
        list(item.getClass()).set(index, item);
        return this;
    }

    /** Removes an item. @param index among the items of the type */
    public WorldBuilder remove(Class<? extends WorldItem> type, int index) {
        items.get(type).remove(index);
        return this;
    }

    /** The list of a type, to which only items of that type are given. */
    @SuppressWarnings("unchecked")
    private List<WorldItem> list(Class<? extends WorldItem> type) {
        return (List<WorldItem>) items.get(type);
    }

    public World build() {
        return new World(
                name,
                segments,
                points,
                pointDiameterMeters,
                boxes,
                homes,
                forbiddenLines,
                forbiddenAreas,
                treadmills,
                goals);
    }
}
