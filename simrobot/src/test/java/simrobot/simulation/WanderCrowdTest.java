package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simrobot.process.BehaviourKind;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SimulatedRobot;
import simrobot.robot.SonarRing;
import simrobot.world.Cone;
import simrobot.world.Distances;
import simrobot.world.Home;
import simrobot.world.MapReader;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import simrobot.world.WorldFormatException;

/** Many wandering robots: their sonars and their places against a computation without grids and lookups. */
class WanderCrowdTest {
    private static Simulation wanderers(World world, int count) {
        Simulation simulation = new Simulation(world, 1);
        List<String> names = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            names.add("robot-" + i);
        }
        simulation.addRobots(names).forEach(robot -> robot.autonomy().begin(BehaviourKind.WANDER));
        return simulation;
    }

    private static World world(int robots) throws WorldFormatException {
        return MapReader.read("wander.map", WanderWorld.map(robots, 1));
    }

    /** Walls by chance in a square. */
    private static World clutter(int walls, double side, long seed) {
        Random chance = new Random(seed);
        List<Segment> segments = new ArrayList<>();
        for (int i = 0; i < walls; i++) {
            double x = chance.nextDouble() * side;
            double y = chance.nextDouble() * side;
            segments.add(new Segment(x, y, x + chance.nextGaussian() * 2, y + chance.nextGaussian() * 2));
        }
        return World.of("clutter", segments);
    }

    /** Where a robot was after a step. */
    private record Place(double x, double y, double heading, boolean rolls) {
        static Place of(SimulatedRobot robot) {
            boolean rolls = robot.speedMetersPerSecond() != 0 || robot.turnRadiansPerSecond() != 0;
            return new Place(robot.xMeters(), robot.yMeters(), robot.headingRadians(), rolls);
        }

        Position at(double ahead, double left) {
            double cos = Math.cos(heading);
            double sin = Math.sin(heading);
            return new Position(x + ahead * cos - left * sin, y + ahead * sin + left * cos);
        }
    }

    /** All places after each step, the first ones before any step. */
    private static final class History {
        private final List<List<Place>> steps = new ArrayList<>();
        private final World world;

        History(Simulation simulation) {
            world = simulation.world();
            remember(simulation);
            simulation.addStepListener(nanos -> remember(simulation));
        }

        private void remember(Simulation simulation) {
            steps.add(simulation.robots().stream().map(Place::of).toList());
        }

        /** The step after which a sonar measured last: one of each array in 4 steps, or all as the robot came to rest. */
        int firing(int robot, int sonar) {
            int last = steps.size() - 1;
            for (int step = last; step > 0; step--) {
                boolean fires = step % 4 == 0 && step / 4 % 8 == sonar % 8;
                boolean rests = steps.get(step - 1).get(robot).rolls()
                        && !steps.get(step).get(robot).rolls();
                if (fires || rests) {
                    return step;
                }
            }
            return 0;
        }

        /** The sides of everything that a robot's sonars could measure after a step. */
        List<Segment> sidesAround(int robot, int step) {
            List<Segment> sides = new ArrayList<>(world.obstacles());
            for (int other = 0; other < steps.get(step).size(); other++) {
                double[][] corners = Pioneer2Dx.octagon();
                for (int i = 0; other != robot && i < corners.length; i++) {
                    Place place = steps.get(step).get(other);
                    Position from = place.at(corners[i][0], corners[i][1]);
                    Position to = place.at(corners[(i + 1) % corners.length][0], corners[(i + 1) % corners.length][1]);
                    sides.add(new Segment(from.xMeters(), from.yMeters(), to.xMeters(), to.yMeters()));
                }
            }
            return sides;
        }

        double range(int robot, int sonar) {
            int step = firing(robot, sonar);
            return rangeOneByOne(sidesAround(robot, step), steps.get(step).get(robot), sonar);
        }
    }

    private static double rangeOneByOne(List<Segment> sides, Place robot, int sonar) {
        Position mouth = robot.at(SonarRing.mountX(sonar), SonarRing.mountY(sonar));
        double armX = mouth.xMeters() - robot.x();
        double armY = mouth.yMeters() - robot.y();
        double arm = Math.hypot(armX, armY);
        Cone cone = new Cone(
                mouth.xMeters(),
                mouth.yMeters(),
                robot.heading() + SonarRing.directionRadians(sonar),
                Pioneer2Dx.SONAR_CONE_RADIANS);
        double nearest = 5;
        for (Segment side : sides) {
            double x1 = side.x1Meters();
            double y1 = side.y1Meters();
            double x2 = side.x2Meters();
            double y2 = side.y2Meters();
            if (Distances.alongRay(robot.x(), robot.y(), armX / arm, armY / arm, x1, y1, x2, y2) < arm) {
                return 0.1;
            }
            nearest = Math.min(nearest, cone.distanceToSegment(x1, y1, x2, y2));
        }
        return Math.max(0.1, nearest);
    }

    private static void assertSonarsMeasureWhatIsThere(Simulation simulation, int checks, int every) {
        History history = new History(simulation);
        for (int check = 0; check < checks; check++) {
            simulation.run(37);
            for (int i = check % every; i < simulation.robots().size(); i += every) {
                double[] ranges = simulation.robots().get(i).sonarRangesMeters();
                for (int sonar = 0; sonar < SonarRing.COUNT; sonar++) {
                    assertEquals(
                            history.range(i, sonar),
                            ranges[sonar],
                            1e-9,
                            "check " + check + ", robot " + i + ", sonar " + sonar);
                }
            }
        }
    }

    @Test
    void sonarsMeasureWhatACheckOfEverythingMeasures() throws WorldFormatException {
        assertSonarsMeasureWhatIsThere(wanderers(world(10), 10), 150, 3);
        assertSonarsMeasureWhatIsThere(wanderers(world(100), 100), 30, 13);
    }

    @Test
    void theyDoSoAmongManyWalls() {
        assertSonarsMeasureWhatIsThere(wanderers(clutter(300, 25, 2), 30), 40, 7);
    }

    @Test
    void theyDoSoInADenseCrowdOnAnOpenFloor() {
        assertSonarsMeasureWhatIsThere(wanderers(clutter(2, 60, 3), 300), 15, 29);
    }

    @Test
    void noRobotOverlapsAWallOrAnotherRobot() throws WorldFormatException {
        World world = world(100);
        Simulation simulation = wanderers(world, 100);
        for (int check = 0; check < 100; check++) {
            simulation.run(50);
            assertNoOverlap(world, simulation.robots());
        }
    }

    private static void assertNoOverlap(World world, List<SimulatedRobot> robots) {
        for (int i = 0; i < robots.size(); i++) {
            double x = robots.get(i).xMeters();
            double y = robots.get(i).yMeters();
            for (Segment wall : world.items(Segment.class)) {
                double gap =
                        Distances.toSegment(x, y, wall.x1Meters(), wall.y1Meters(), wall.x2Meters(), wall.y2Meters());
                assertTrue(gap >= 0.25, "robot " + i + " is " + gap + " m from a wall");
            }
            for (int j = 0; j < i; j++) {
                double gap = Math.hypot(
                        x - robots.get(j).xMeters(), y - robots.get(j).yMeters());
                assertTrue(gap >= 0.5, "robots " + i + " and " + j + " are " + gap + " m apart");
            }
        }
    }

    @Test
    void tenThousandRobotsStandOnTheirHomes() throws WorldFormatException {
        World world = world(10_000);
        Simulation simulation = wanderers(world, 10_000);
        for (int i = 0; i < 10_000; i++) {
            assertEquals(
                    world.items(Home.class).get(i).position().xMeters(),
                    simulation.robots().get(i).xMeters());
        }
        simulation.step();
    }
}
