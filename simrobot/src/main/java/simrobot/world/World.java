package simrobot.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * Everything that stands or lies on the floor; immutable.
 *
 * @param name for titles: the file's name without folder
 * @param segments walls; they stop robots and sonar
 * @param points small obstacles, each of {@link #pointDiameterMeters} to a single ray; they stop robots and sonar
 * @param boxes furniture; its sides stop robots and sonar
 * @param homes where robots start, in the file's order
 * @param forbiddenLines drawn only: they bind planners, not wheels
 * @param forbiddenAreas drawn only
 * @param treadmills belts that carry robots
 * @param goals drawn only
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

    /** Robots get this much floor when a world has no obstacle at all, in metres. */
    private static final double BARE_FLOOR_METERS = 10;

    /** Two robots side by side. */
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

    /** A floor without anything on it. */
    public static World bare() {
        return ofSegments("bare", List.of());
    }

    /** A floor with nothing but walls. */
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

    /** The smallest upright rectangle around all that the world holds. */
    public Area bounds() {
        double[] box = {
            Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY
        };
        Stream.concat(segments.stream(), forbiddenLines.stream()).forEach(s -> {
            grow(box, s.x1Meters(), s.y1Meters());
            grow(box, s.x2Meters(), s.y2Meters());
        });
        points.forEach(p -> grow(box, p.xMeters(), p.yMeters()));
        homes.forEach(
                home -> grow(box, home.position().xMeters(), home.position().yMeters()));
        goals.forEach(
                goal -> grow(box, goal.position().xMeters(), goal.position().yMeters()));
        Stream.of(
                        boxes.stream().map(Box::area),
                        forbiddenAreas.stream(),
                        treadmills.stream().map(Treadmill::area))
                .flatMap(areas -> areas)
                .flatMap(area -> area.corners().stream())
                .forEach(p -> grow(box, p.xMeters(), p.yMeters()));
        if (box[0] > box[2]) {
            return new Area(-BARE_FLOOR_METERS, -BARE_FLOOR_METERS, BARE_FLOOR_METERS, BARE_FLOOR_METERS, 0);
        }
        return new Area(box[0], box[1], box[2], box[3], 0);
    }

    /**
     * Where robots may be put: within the bounds. A world that is less than 1 m wide or deep, such as a single wall,
     * encloses nothing; it is 20 m of bare floor around its middle, with that on it.
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

    private static void grow(double[] box, double x, double y) {
        box[0] = Math.min(box[0], x);
        box[1] = Math.min(box[1], y);
        box[2] = Math.max(box[2], x);
        box[3] = Math.max(box[3], y);
    }
}
