package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class MovingDiscTest {
    private static final double RADIUS = 0.25;
    private static final Segment WALL = new Segment(2, -1, 2, 1);

    private static Contact sweep(double x, double y, double dx, double dy) {
        return new ObstacleGrid(World.of("wall", List.of(WALL))).sweep(x, y, dx, dy, RADIUS);
    }

    @Test
    void aWallAheadStopsTheDiscOneRadiusBeforeIt() {
        Contact contact = sweep(0, 0, 4, 0);
        assertEquals(1.75, 4 * contact.fraction(), 2e-7);
        assertTrue(4 * contact.fraction() < 1.75);
        assertEquals(-1, contact.normalX(), 1e-12);
    }

    @Test
    void aStepTooLongToNoticeTheWallStillStopsAtIt() {
        assertEquals(1.75, 1000 * sweep(0, 0, 1000, 0).fraction(), 2e-7);
    }

    @Test
    void theWallsEndIsRound() {
        double past = 1 + RADIUS * Math.sqrt(0.5);
        Contact contact = sweep(0, past, 4, 0);
        assertEquals(2 - RADIUS * Math.sqrt(0.5), 4 * contact.fraction(), 1e-6);
        assertEquals(Math.sqrt(0.5), contact.normalY(), 1e-6);
    }

    @Test
    void aWayThatEndsShortOfContactIsFree() {
        assertFalse(sweep(0, 0, 1.74, 0).touches());
        assertFalse(sweep(0, 1.2501, 4, 0).touches());
        assertTrue(sweep(0, 1.2499, 4, 0).touches());
    }

    @Test
    void atContactOnlyTheWayIntoTheWallIsClosed() {
        double x = 4 * sweep(0, 0, 4, 0).fraction();
        assertEquals(0, sweep(x, 0, 1, 0).fraction(), 1e-9);
        assertEquals(0, sweep(x, 0, 0.001, 1).fraction(), 1e-3);
        assertFalse(sweep(x, 0, 0, 0.7).touches());
        assertFalse(sweep(x, 0, 0, -0.7).touches());
        assertFalse(sweep(x, 0, -1, 0.3).touches());
        assertFalse(sweep(x, 0, -1, 0).touches());
    }

    @Test
    void anExactlyTouchingDiscMayGoAlongTheWallForKilometres() {
        World world = World.of("wall", List.of(new Segment(-5000, RADIUS, 5000, RADIUS)));
        assertFalse(new ObstacleGrid(world).sweep(-4000, 0, 8000, 0, RADIUS).touches());
    }

    @Test
    void aDiscBetweenTwoTouchingWallsMayLeaveAndNothingElse() {
        World world = World.of("corner", List.of(new Segment(0, 0, 5, 0), new Segment(0, 0, 0, 5)));
        ObstacleGrid grid = new ObstacleGrid(world);
        double r = RADIUS + 1e-7;
        assertEquals(0, grid.sweep(r, r, -1, 0, RADIUS).fraction());
        assertEquals(0, grid.sweep(r, r, 0, -1, RADIUS).fraction());
        assertFalse(grid.sweep(r, r, 1, 1, RADIUS).touches());
        assertFalse(grid.sweep(r, r, 0, 1, RADIUS).touches());
    }

    /** Whatever the angle, the length and the obstacle: at contact the gap is above 0 and below a micrometre. */
    @Test
    void contactIsExactForRandomWallsPointsAndWays() {
        Random random = new Random(7);
        int contacts = 0;
        for (int i = 0; i < 20_000; i++) {
            Segment wall = new Segment(
                    random.nextGaussian() * 3,
                    random.nextGaussian() * 3,
                    random.nextGaussian() * 3,
                    random.nextGaussian() * 3);
            boolean point = i % 3 == 0;
            Segment obstacle =
                    point ? new Segment(wall.x1Meters(), wall.y1Meters(), wall.x1Meters(), wall.y1Meters()) : wall;
            ObstacleGrid grid = new ObstacleGrid(World.of("random", List.of(obstacle)));
            double x = random.nextGaussian() * 4;
            double y = random.nextGaussian() * 4;
            double length = Math.pow(10, -3 + 4 * random.nextDouble());
            double aim = random.nextDouble();
            double aimX = wall.x1Meters() + aim * (obstacle.x2Meters() - wall.x1Meters());
            double aimY = wall.y1Meters() + aim * (obstacle.y2Meters() - wall.y1Meters());
            double angle = Math.atan2(aimY - y, aimX - x) + random.nextGaussian() * 0.1;
            double dx = length * Math.cos(angle);
            double dy = length * Math.sin(angle);
            if (distance(obstacle, x, y) <= RADIUS + 1e-6) {
                continue;
            }
            Contact contact = grid.sweep(x, y, dx, dy, RADIUS);
            double share = contact.fraction();
            double gap = distance(obstacle, x + dx * share, y + dy * share) - RADIUS;
            assertTrue(gap >= 0, "inside by " + gap);
            if (contact.touches()) {
                contacts++;
                assertTrue(gap < 1e-6, "stands off by " + gap);
            } else {
                for (int k = 1; k < 50; k++) {
                    assertTrue(distance(obstacle, x + dx * k / 50, y + dy * k / 50) >= RADIUS);
                }
            }
        }
        assertTrue(contacts > 1000, contacts + " contacts");
    }

    private static double distance(Segment wall, double x, double y) {
        return Distances.toSegment(x, y, wall.x1Meters(), wall.y1Meters(), wall.x2Meters(), wall.y2Meters());
    }
}
