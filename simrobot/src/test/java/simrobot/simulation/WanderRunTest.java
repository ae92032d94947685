package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.robot.SonarRing;
import simrobot.world.Distances;
import simrobot.world.Home;
import simrobot.world.MapReader;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import simrobot.world.WorldFormatException;

/** The wanderers of the speed comparison against a simulator that knows no grid and no list. */
class WanderRunTest {
    private static World world(int robots) throws WorldFormatException {
        return MapReader.read("wander.map", WanderWorld.map(robots, 1));
    }

    /** Walls and points by chance in a square, crowded or open. */
    private static World clutter(int walls, int points, double side, long seed) {
        Random chance = new Random(seed);
        List<Segment> segments = new ArrayList<>();
        for (int i = 0; i < walls; i++) {
            double x = chance.nextDouble() * side;
            double y = chance.nextDouble() * side;
            segments.add(new Segment(x, y, x + chance.nextGaussian() * 2, y + chance.nextGaussian() * 2));
        }
        List<Position> dots = new ArrayList<>();
        for (int i = 0; i < points; i++) {
            dots.add(new Position(chance.nextDouble() * side, chance.nextDouble() * side));
        }
        return new World(
                "clutter", segments, dots, 0.02, List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
    }

    private static double rangeOneByOne(World world, double[][] poses, int robot, int sonar) {
        double[] at = poses[robot];
        double cos = StrictMath.cos(at[2]);
        double sin = StrictMath.sin(at[2]);
        double x = at[0] + SonarRing.mountX(sonar) * cos - SonarRing.mountY(sonar) * sin;
        double y = at[1] + SonarRing.mountX(sonar) * sin + SonarRing.mountY(sonar) * cos;
        double direction = SonarRing.directionRadians(sonar);
        double ux = StrictMath.cos(direction) * cos - StrictMath.sin(direction) * sin;
        double uy = StrictMath.cos(direction) * sin + StrictMath.sin(direction) * cos;
        double nearest = 5;
        for (Segment wall : world.segments()) {
            nearest = Math.min(
                    nearest,
                    Distances.alongRay(
                            x, y, ux, uy, wall.x1Meters(), wall.y1Meters(), wall.x2Meters(), wall.y2Meters()));
        }
        for (Position dot : world.points()) {
            nearest = Math.min(nearest, Distances.alongRayToDisc(x, y, ux, uy, dot.xMeters(), dot.yMeters(), 0.01));
        }
        for (int other = 0; other < poses.length; other++) {
            if (other != robot) {
                nearest = Math.min(
                        nearest, Distances.alongRayToDisc(x, y, ux, uy, poses[other][0], poses[other][1], 0.25));
            }
        }
        return nearest;
    }

    private static double[][] poses(WanderRun run) {
        double[][] poses = new double[run.robots()][];
        for (int i = 0; i < poses.length; i++) {
            poses[i] = new double[] {run.xMeters(i), run.yMeters(i), run.headingRadians(i)};
        }
        return poses;
    }

    private static void assertSonarsHearWhatIsThere(World world, int robots, int steps, int every) {
        WanderRun run = new WanderRun(world, robots);
        for (int step = 0; step < steps; step++) {
            double[][] before = poses(run);
            run.step();
            for (int robot = step % every; robot < robots; robot += every) {
                for (int sonar = 0; sonar < SonarRing.COUNT; sonar++) {
                    assertEquals(
                            rangeOneByOne(world, before, robot, sonar),
                            run.rangeMeters(robot, sonar),
                            "step " + step + ", robot " + robot + ", sonar " + sonar);
                }
            }
        }
    }

    @Test
    void sonarsHearToTheBitWhatALookAtEverythingHears() throws WorldFormatException {
        assertSonarsHearWhatIsThere(world(10), 10, 1000, 3);
        assertSonarsHearWhatIsThere(world(100), 100, 300, 13);
    }

    @Test
    void soTheyDoWhereVeryMuchStandsAround() {
        assertSonarsHearWhatIsThere(clutter(300, 500, 25, 2), 30, 200, 7);
    }

    @Test
    void soTheyDoInADenseCrowdOnAnOpenFloor() {
        assertSonarsHearWhatIsThere(clutter(2, 0, 60, 3), 300, 60, 29);
    }

    @ParameterizedTest
    @ValueSource(ints = {10, 100})
    void nobodyIsEverInAWallOrInAnother(int robots) throws WorldFormatException {
        World world = world(robots);
        WanderRun run = new WanderRun(world, robots);
        for (int step = 0; step < 2000; step++) {
            run.step();
            if (step % 20 == 0) {
                assertNoOverlap(world, poses(run));
            }
        }
    }

    private static void assertNoOverlap(World world, double[][] poses) {
        for (int i = 0; i < poses.length; i++) {
            for (Segment wall : world.segments()) {
                double gap = Distances.toSegment(
                        poses[i][0], poses[i][1], wall.x1Meters(), wall.y1Meters(), wall.x2Meters(), wall.y2Meters());
                assertTrue(gap >= 0.25, "robot " + i + " is " + gap + " m from a wall");
            }
            for (int j = 0; j < i; j++) {
                double gap = Math.hypot(poses[i][0] - poses[j][0], poses[i][1] - poses[j][1]);
                assertTrue(gap >= 0.4999999, "robots " + i + " and " + j + " are " + gap + " m apart");
            }
        }
    }

    private static WanderRun facingAWall(double wallX) {
        return new WanderRun(
                new World(
                        "wall",
                        List.of(new Segment(wallX, -9, wallX, 9), new Segment(-9, -9, -9, 9)),
                        List.of(),
                        0.02,
                        List.of(),
                        List.of(new Home("", new Position(0, 0), 0, Optional.empty())),
                        List.of(),
                        List.of(),
                        List.of(),
                        List.of()),
                1);
    }

    @Test
    void itGoesFourCentimetersAStepAndTurnsFiveDegrees() {
        WanderRun run = facingAWall(0.166 + 0.5 + 0.1);
        run.step();
        run.step();
        run.step();
        assertEquals(0.12, run.xMeters(0), 1e-12);
        for (int tick = 1; tick <= 10; tick++) {
            run.step();
            assertEquals(0.12, run.xMeters(0), 1e-12);
            assertEquals(Math.toRadians(5 * tick), run.headingRadians(0), 1e-12);
        }
    }

    @Test
    void aWayThatIsBlockedIsNotGoneAndLeavesItStalled() {
        // a post to its left, between the beams of sonars 0 and 1
        World world = new World(
                "post",
                List.of(new Segment(-9, -9, -9, 9)),
                List.of(new Position(0.1, 0.249)),
                0.02,
                List.of(),
                List.of(new Home("", new Position(0, 0), 0, Optional.empty())),
                List.of(),
                List.of(),
                List.of(),
                List.of());
        WanderRun run = new WanderRun(world, 1);
        run.step();
        assertFalse(run.isStalled(0));
        for (int step = 0; step < 5; step++) {
            run.step();
            assertTrue(run.isStalled(0));
            assertEquals(0.04, run.xMeters(0), 1e-12);
            assertEquals(0, run.yMeters(0));
        }
    }

    @Test
    void theSameWorldGivesTheSameRunToTheBit() throws WorldFormatException {
        WanderRun one = new WanderRun(world(100), 100);
        WanderRun two = new WanderRun(world(100), 100);
        for (int step = 0; step < 500; step++) {
            one.step();
            two.step();
        }
        for (int i = 0; i < 100; i++) {
            assertEquals(one.xMeters(i), two.xMeters(i));
            assertEquals(one.headingRadians(i), two.headingRadians(i));
        }
        assertFalse(one.isStalled(0) != two.isStalled(0));
    }

    @Test
    void tenThousandRobotsFindTheirHomes() throws WorldFormatException {
        World world = world(10_000);
        WanderRun run = new WanderRun(world, 10_000);
        for (int i = 0; i < 10_000; i++) {
            assertEquals(world.homes().get(i).position().xMeters(), run.xMeters(i));
        }
        run.step();
    }
}
