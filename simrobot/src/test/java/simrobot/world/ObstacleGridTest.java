package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The grid against plain loops over all obstacles. */
class ObstacleGridTest {
    private final Random random = new Random(11);
    private final List<Segment> walls = new ArrayList<>();
    private final List<Point> points = new ArrayList<>();
    private ObstacleGrid grid;

    @BeforeEach
    void aWorldOfManyWallsAndPoints() {
        for (int i = 0; i < 150; i++) {
            double x = random.nextDouble() * 40 - 20;
            double y = random.nextDouble() * 30 - 10;
            boolean upright = i % 3 == 0;
            walls.add(new Segment(
                    x, y, upright ? x : x + random.nextGaussian() * 3, i % 3 == 1 ? y : y + random.nextGaussian() * 3));
            points.add(new Point(random.nextDouble() * 40 - 20, random.nextDouble() * 30 - 10));
        }
        grid = grid(walls, points);
    }

    private static ObstacleGrid grid(List<Segment> walls, List<Point> points) {
        WorldBuilder builder = new WorldBuilder("grid");
        walls.forEach(builder::add);
        points.forEach(builder::add);
        return new ObstacleGrid(builder.build());
    }

    @Test
    void raysMeetWhatALoopOverAllMeets() {
        for (int i = 0; i < 5000; i++) {
            double x = random.nextDouble() * 60 - 30;
            double y = random.nextDouble() * 50 - 20;
            double angle = i % 8 == 0 ? (i / 8 % 4) * Math.PI / 2 : random.nextDouble() * 2 * Math.PI;
            double ux = i % 16 == 0 ? Math.rint(Math.cos(angle)) : Math.cos(angle);
            double uy = i % 16 == 0 ? Math.rint(Math.sin(angle)) : Math.sin(angle);
            double expected = 8;
            for (Segment s : walls) {
                expected = Math.min(
                        expected,
                        Distances.alongRay(x, y, ux, uy, s.x1Meters(), s.y1Meters(), s.x2Meters(), s.y2Meters()));
            }
            for (Point p : points) {
                expected = Math.min(expected, Distances.alongRayToDisc(x, y, ux, uy, p.xMeters(), p.yMeters(), 0.01));
            }
            assertEquals(expected, grid.rayRange(x, y, ux, uy, 8), 1e-12);
        }
    }

    @Test
    void conesHearWhatALoopOverAllHears() {
        for (int i = 0; i < 2000; i++) {
            double x = random.nextDouble() * 50 - 25;
            double y = random.nextDouble() * 40 - 15;
            NearbyObstacles nearby = grid.near(x, y, 6);
            x += random.nextDouble() - 0.5;
            y += random.nextDouble() - 0.5;
            Cone cone = new Cone(x, y, random.nextDouble() * 20 - 10, Math.toRadians(15));
            assertTrue(nearby.covers(grid, x, y, 5));
            double expected = 5;
            for (Segment s : walls) {
                expected = Math.min(
                        expected, cone.distanceToSegment(s.x1Meters(), s.y1Meters(), s.x2Meters(), s.y2Meters()));
            }
            for (Point p : points) {
                expected = Math.min(expected, cone.distanceToPoint(p.xMeters(), p.yMeters()));
            }
            assertEquals(expected, nearby.coneRange(cone, 5), 1e-12);
        }
    }

    @Test
    void clearanceIsTheLeastDistance() {
        for (int i = 0; i < 2000; i++) {
            double x = random.nextDouble() * 50 - 25;
            double y = random.nextDouble() * 40 - 15;
            double expected = 0.7;
            for (Segment s : walls) {
                expected = Math.min(
                        expected, Distances.toSegment(x, y, s.x1Meters(), s.y1Meters(), s.x2Meters(), s.y2Meters()));
            }
            for (Point p : points) {
                expected = Math.min(expected, Math.hypot(p.xMeters() - x, p.yMeters() - y));
            }
            assertEquals(expected, grid.clearance(x, y, 0.7), 1e-12);
        }
    }

    @Test
    void sweepsMeetWhatALoopOverAllMeets() {
        for (int i = 0; i < 5000; i++) {
            double x = random.nextDouble() * 50 - 25;
            double y = random.nextDouble() * 40 - 15;
            double dx = random.nextGaussian();
            double dy = random.nextGaussian();
            MovingDisc disc = new MovingDisc(x, y, dx, dy, 0.25);
            walls.forEach(s -> disc.addSegment(s.x1Meters(), s.y1Meters(), s.x2Meters(), s.y2Meters()));
            points.forEach(p -> disc.addPoint(p.xMeters(), p.yMeters()));
            assertEquals(
                    disc.contact().fraction(), grid.sweep(x, y, dx, dy, 0.25).fraction());
        }
    }

    @Test
    void aPlaceIsFreeIfTheLeastDistanceIsTheRadiusOrMore() {
        int free = 0;
        for (int i = 0; i < 3000; i++) {
            double x = random.nextDouble() * 50 - 25;
            double y = random.nextDouble() * 40 - 15;
            double radius = 0.1 + random.nextDouble();
            boolean expected = points.stream().allMatch(p -> Math.hypot(p.xMeters() - x, p.yMeters() - y) >= radius)
                    && walls.stream()
                            .allMatch(s ->
                                    Distances.toSegment(x, y, s.x1Meters(), s.y1Meters(), s.x2Meters(), s.y2Meters())
                                            >= radius);
            assertEquals(expected, grid.isFree(x, y, radius));
            free += expected ? 1 : 0;
        }
        assertTrue(free > 500 && free < 2500, free + " free");
    }

    @Test
    void aPlaceThatIsExactlyOneRadiusAwayIsFree() {
        ObstacleGrid wall = new ObstacleGrid(World.of("wall", List.of(new Segment(0, 0, 4, 0))));
        assertTrue(wall.isFree(2, 0.25, 0.25));
        assertFalse(wall.isFree(2, 0.24999, 0.25));
        assertTrue(wall.isFree(4.25, 0, 0.25));
        assertFalse(wall.isFree(-0.24999, 0, 0.25));
    }

    /** Rays that begin far outside enter the grid at its border, whatever side they come from. */
    @Test
    void raysFromFarOutsideMeetWhatALoopOverAllMeets() {
        for (int i = 0; i < 3000; i++) {
            double angle = random.nextDouble() * 2 * Math.PI;
            double x = 90 * Math.cos(angle);
            double y = 5 + 90 * Math.sin(angle);
            double towards = Math.atan2(random.nextDouble() * 40 - 15 - y, random.nextDouble() * 50 - 25 - x);
            assertRay(x, y, Math.cos(towards), Math.sin(towards), 120);
        }
        for (int i = 0; i < 400; i++) {
            double at = random.nextDouble() * 60 - 30;
            assertRay(at, -50, 0, 1, 80);
            assertRay(at, 60, 0, -1, 80);
            assertRay(-50, at, 1, 0, 80);
            assertRay(50, at, -1, 0, 80);
            assertRay(at, -50, 0, -1, 80);
            assertRay(50, at, 1, 0, 80);
        }
    }

    private void assertRay(double x, double y, double ux, double uy, double max) {
        double expected = max;
        for (Segment s : walls) {
            expected = Math.min(
                    expected, Distances.alongRay(x, y, ux, uy, s.x1Meters(), s.y1Meters(), s.x2Meters(), s.y2Meters()));
        }
        for (Point p : points) {
            expected = Math.min(expected, Distances.alongRayToDisc(x, y, ux, uy, p.xMeters(), p.yMeters(), 0.01));
        }
        assertEquals(expected, grid.rayRange(x, y, ux, uy, max), 1e-9);
    }

    @Test
    void aDiscThatDoesNotMoveTouchesNothing() {
        assertSame(Contact.NONE, grid.sweep(0, 0, 0, 0, 0.25));
    }

    @Test
    void aSweepHasTheDirectionOfTheFirstContact() {
        for (int i = 0; i < 2000; i++) {
            double x = random.nextDouble() * 50 - 25;
            double y = random.nextDouble() * 40 - 15;
            double dx = i % 4 == 0 ? 0 : random.nextGaussian() * 3;
            double dy = i % 4 == 1 ? 0 : random.nextGaussian() * 3;
            MovingDisc disc = new MovingDisc(x, y, dx, dy, 0.25);
            walls.forEach(s -> disc.addSegment(s.x1Meters(), s.y1Meters(), s.x2Meters(), s.y2Meters()));
            points.forEach(p -> disc.addPoint(p.xMeters(), p.yMeters()));
            assertEquals(
                    disc.contact().fraction(), grid.sweep(x, y, dx, dy, 0.25).fraction());
        }
    }

    /** Walls on the lines between cells and points at the corners of cells. */
    @Test
    void obstaclesOnTheBordersOfCellsAreFoundFromAllSides() {
        walls.clear();
        points.clear();
        for (int i = 0; i <= 20; i++) {
            walls.add(new Segment(i * 0.5, i % 2, i * 0.5, i % 2 + 0.5));
            walls.add(new Segment(i % 3, i * 0.5, i % 3 + 0.5, i * 0.5));
            points.add(new Point(i * 0.5, 10 - i * 0.5));
        }
        grid = grid(walls, points);
        for (int i = 0; i < 4000; i++) {
            double x = Math.rint(random.nextDouble() * 48 - 4) / 4;
            double y = Math.rint(random.nextDouble() * 48 - 4) / 4;
            double angle = i % 2 == 0 ? random.nextInt(8) * Math.PI / 4 : random.nextDouble() * 2 * Math.PI;
            assertRay(x + 0.1, y + 0.07, Math.cos(angle), Math.sin(angle), 15);
        }
    }

    @Test
    void aBareFloorHasNothingToMeet() {
        ObstacleGrid bare = new ObstacleGrid(World.bare());
        assertEquals(5, bare.rayRange(0, 0, 1, 0, 5));
        assertEquals(5, bare.near(0, 0, 6).coneRange(new Cone(0, 0, 1, 0.2), 5));
        assertEquals(1, bare.clearance(3, 3, 1));
        assertFalse(bare.sweep(0, 0, 100, 0, 0.25).touches());
    }

    @Test
    void aWorldOfContinentalSizeStaysWithinItsCells() {
        ObstacleGrid huge =
                new ObstacleGrid(World.of("huge", List.of(new Segment(0, 0, 4e6, 3e6), new Segment(1, 0, 1, 1))));
        assertEquals(0.5, huge.rayRange(0.5, 0.1, 1, 0, 5), 0.4);
        assertTrue(huge.sweep(2, 0.9, -1, 0, 0.25).touches());
    }
}
