package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

class WorldTest {
    private static final Segment WALL = new Segment(1, 2, 3, 4);
    private static final Box BOX = new Box("desk", new Area(-1, -2, 5, 6, 0));
    private static final Home HOME = new Home("A", new Position(7, -8), 0, Optional.empty());
    private static final Treadmill BELT = new Treadmill(new Area(-9, 0, 0, 10, 0), 0.5, 0);

    private static World withAll() {
        WorldBuilder builder = new WorldBuilder("all");
        builder.add(WALL).add(BOX).add(HOME).add(BELT);
        builder.add(new Point(11, -12));
        builder.add(new ForbiddenLine(new Segment(-13, 14, 0, 0)));
        builder.add(new ForbiddenArea(new Area(0, 0, 15, 16, 0)));
        builder.add(new Goal("Goal", "B", new Position(-17, -18), 0));
        return builder.pointDiameter(0.05).build();
    }

    static Stream<Consumer<WorldBuilder>> thingsAtThreeFiveAndSevenNine() {
        return Stream.of(
                world -> world.add(new Segment(3, 5, 7, 9)),
                world -> world.add(new Segment(7, 9, 3, 5)),
                world -> world.add(new Box("box", new Area(3, 5, 7, 9, 0))),
                world -> world.add(new Treadmill(new Area(3, 5, 7, 9, 0), 1, 0)),
                world -> world.add(new Home("", new Position(3, 9), 0, Optional.empty()))
                        .add(new Home("", new Position(7, 5), 0, Optional.empty())),
                world -> world.add(new Point(3, 9)).add(new Point(7, 5)),
                world -> world.add(new ForbiddenLine(new Segment(3, 9, 7, 5))),
                world -> world.add(new ForbiddenArea(new Area(3, 5, 7, 9, 0))),
                world -> world.add(new Goal("Goal", "", new Position(7, 9), 0))
                        .add(new Goal("Dock", "", new Position(3, 5), 0)));
    }

    @ParameterizedTest
    @MethodSource("thingsAtThreeFiveAndSevenNine")
    void theBoundsHoldEverythingOfEachKind(Consumer<WorldBuilder> things) {
        WorldBuilder builder = new WorldBuilder("one kind");
        things.accept(builder);
        assertEquals(new Area(3, 5, 7, 9, 0), builder.build().bounds());
    }

    @Test
    void theBoundsOfTurnedFurnitureHoldItsTurnedCorners() {
        World world = new WorldBuilder("turned")
                .add(new Box("box", new Area(1, 2, 4, 3, Math.PI / 2)))
                .build();
        assertEquals(-3, world.bounds().minXMeters(), 1e-12);
        assertEquals(4, world.bounds().maxYMeters(), 1e-12);
    }

    @Test
    void anEmptyWorldIsTwentyMetersOfBareFloor() {
        assertEquals(new Area(-10, -10, 10, 10, 0), World.bare().bounds());
        assertEquals(new Area(-10, -10, 10, 10, 0), World.bare().ground());
    }

    @Test
    void aWorldOfASinglePointHasBoundsWithoutExtent() {
        WorldBuilder builder = new WorldBuilder("point");
        builder.add(new Point(2, 3));
        assertEquals(new Area(2, 3, 2, 3, 0), builder.build().bounds());
    }

    @ParameterizedTest
    @CsvSource({
        // bounds that are 1 m wide and deep or more are the ground
        "0, 0, 1, 1,       0, 0, 1, 1",
        "2, 3, 3, 30,      2, 3, 3, 30",
        // less in one direction: 10 m of floor to each side of the middle, and all of the world
        "0, 0, 0.99, 1,    -9.505, -9.5, 10.495, 10.5",
        "0, 0, 1, 0.99,    -9.5, -9.505, 10.5, 10.495",
        "5, 0, 5, 4,       -5, -8, 15, 12",
        "0, 2, 60, 2,      0, -8, 60, 12",
        "3, -40, 3, 40,    -7, -40, 13, 40"
    })
    void theGroundIsTheBoundsIfTheyEncloseAMeterInBothDirections(
            double x1, double y1, double x2, double y2, double left, double low, double right, double high) {
        Area ground = World.of("wall", List.of(new Segment(x1, y1, x2, y2))).ground();
        assertEquals(left, ground.minXMeters(), 1e-12);
        assertEquals(low, ground.minYMeters(), 1e-12);
        assertEquals(right, ground.maxXMeters(), 1e-12);
        assertEquals(high, ground.maxYMeters(), 1e-12);
    }

    @Test
    void anotherNameLeavesTheContents() {
        World world = withAll();
        World named = world.named("other");
        assertEquals("other", named.name());
        assertEquals(world, named.named("all"));
        assertEquals(world, world.toBuilder().build());
    }

    @Test
    void itemsAreListedByType() {
        World world = withAll();
        assertEquals(List.of(WALL), world.items(Segment.class));
        assertEquals(List.of(BOX), world.items(Box.class));
        assertEquals(List.of(HOME), world.items(Home.class));
        assertEquals(List.of(BELT), world.items(Treadmill.class));
    }

    @Test
    void itemsAreAddedReplacedAndRemovedByType() {
        Segment other = new Segment(0, 0, 1, 0);
        World world = withAll().toBuilder().add(other).set(0, other).build();
        assertEquals(List.of(other, other), world.items(Segment.class));
        assertEquals(List.of(BOX), world.items(Box.class));
        assertEquals(
                List.of(),
                world.toBuilder()
                        .remove(Home.class, 0)
                        .remove(Box.class, 0)
                        .build()
                        .items(Box.class));
    }

    @Test
    void theObstaclesAreTheWallsAndTheSidesOfTheFurniture() {
        List<Segment> obstacles = withAll().obstacles();
        assertEquals(5, obstacles.size());
        assertEquals(WALL, obstacles.get(0));
        assertEquals(BOX.area().sides(), obstacles.subList(1, 5));
    }

    @Test
    void aPointHasADiameterOfZeroOrMore() {
        WorldBuilder builder = new WorldBuilder("points");
        builder.pointDiameter(0);
        assertEquals(0, builder.build().pointDiameterMeters());
        builder.pointDiameter(-0.01);
        assertThrows(IllegalArgumentException.class, builder::build);
        builder.pointDiameter(Double.NaN);
        assertThrows(IllegalArgumentException.class, builder::build);
    }
}
