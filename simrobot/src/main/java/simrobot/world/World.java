package simrobot.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * The floor and everything on it; immutable.
 *
 * @param name for titles: the file's name without folder
 * @param segments walls; they stop robots and sonar
 * @param points small obstacles, each of {@link #pointDiameterMeters} to a single ray; they stop robots and sonar
 * @param boxes furniture; its sides stop robots and sonar
 * @param homes where robots start, in the file's order
 * @param forbiddenLines they bind planners, not wheels
 * @param forbiddenAreas they bind planners, not wheels
 * @param treadmills belts that carry robots
 * @param goals places to which robots can be sent
 */
public record World(
        String name,
        List<Segment> segments,
        List<Position> points,
        double pointDiameterMeters,
        List<Box> boxes,
        List<Home> homes,
        List<Segment> forbiddenLines,
        List<Area> forbiddenAreas,
        List<Treadmill> treadmills,
        List<Goal> goals) {

    /** Half the side of a world without anything in it. */
    private static final double BARE_FLOOR_METERS = 10;

    /** Width of two robots side by side. */
    private static final double ROOM_METERS = 1;

    public World {
        Objects.requireNonNull(name);
        segments = List.copyOf(segments);
        points = List.copyOf(points);
        boxes = List.copyOf(boxes);
        homes = List.copyOf(homes);
        forbiddenLines = List.copyOf(forbiddenLines);
        forbiddenAreas = List.copyOf(forbiddenAreas);
        treadmills = List.copyOf(treadmills);
        goals = List.copyOf(goals);
        if (!(pointDiameterMeters >= 0)) {
            throw new IllegalArgumentException("a point's diameter is " + pointDiameterMeters + ", expected 0 or more");
        }
    }

    /** A world without anything in it. */
    public static World bare() {
        return ofSegments("bare", List.of());
    }

    /** A world of walls only. */
    public static World ofSegments(String name, List<Segment> segments) {
        WorldBuilder builder = new WorldBuilder(name);
        segments.forEach(builder::add);
        return builder.build();
    }

    public World named(String newName) {
        return new WorldBuilder(this, newName).build();
    }

    /** A builder that holds the contents of this world. */
    public WorldBuilder toBuilder() {
        return new WorldBuilder(this, name);
    }

    /** The items of a type, in the file's order. */
    public List<? extends WorldItem> items(Class<? extends WorldItem> type) {
        return Map.<Class<?>, List<? extends WorldItem>>of(
                        Segment.class, segments, Box.class, boxes, Home.class, homes, Treadmill.class, treadmills)
                .get(type);
    }

    /** Every straight obstacle: walls, then the sides of the boxes. */
    public List<Segment> obstacles() {
        List<Segment> all = new ArrayList<>(segments);
        boxes.forEach(box -> all.addAll(box.area().sides()));
        return all;
    }

    /** The smallest upright rectangle around everything in the world. */
    public Area bounds() {
        BoundingBox bounds = new BoundingBox();
        segments.forEach(bounds::add);
        forbiddenLines.forEach(bounds::add);
        points.forEach(bounds::add);
        homes.forEach(home -> bounds.add(home.position()));
        goals.forEach(goal -> bounds.add(goal.position()));
        boxes.forEach(box -> box.area().corners().forEach(bounds::add));
        forbiddenAreas.forEach(area -> area.corners().forEach(bounds::add));
        treadmills.forEach(belt -> belt.area().corners().forEach(bounds::add));
        return bounds.or(new Area(-BARE_FLOOR_METERS, -BARE_FLOOR_METERS, BARE_FLOOR_METERS, BARE_FLOOR_METERS, 0));
    }

    /**
     * The area in which robots may be placed: the bounds, or, for a world less than 1 m wide or deep such as a single wall,
     * 20 m of floor around its middle.
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
}
