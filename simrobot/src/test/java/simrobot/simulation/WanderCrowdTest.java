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
        return World.ofSegments("clutter", segments);
    }

    /** The sides of everything that a robot's sonars can measure. */
    private static List<Segment> sidesAround(Simulation simulation, SimulatedRobot robot) {
        List<Segment> sides = new ArrayList<>(simulation.world().obstacles());
        for (SimulatedRobot other : simulation.robots()) {
            double[][] corners = Pioneer2Dx.octagon();
            for (int i = 0; other != robot && i < corners.length; i++) {
                Position from = place(other, corners[i][0], corners[i][1]);
                Position to = place(other, corners[(i + 1) % corners.length][0], corners[(i + 1) % corners.length][1]);
                sides.add(new Segment(from.xMeters(), from.yMeters(), to.xMeters(), to.yMeters()));
            }
        }
        return sides;
    }

    private static Position place(SimulatedRobot robot, double ahead, double left) {
        double cos = Math.cos(robot.headingRadians());
        double sin = Math.sin(robot.headingRadians());
        return new Position(robot.xMeters() + ahead * cos - left * sin, robot.yMeters() + ahead * sin + left * cos);
    }

    private static double rangeOneByOne(List<Segment> sides, SimulatedRobot robot, int sonar) {
        Position mouth = place(robot, SonarRing.mountX(sonar), SonarRing.mountY(sonar));
        double armX = mouth.xMeters() - robot.xMeters();
        double armY = mouth.yMeters() - robot.yMeters();
        double arm = Math.hypot(armX, armY);
        Cone cone = new Cone(
                mouth.xMeters(),
                mouth.yMeters(),
                robot.headingRadians() + SonarRing.directionRadians(sonar),
                Pioneer2Dx.SONAR_CONE_RADIANS);
        double nearest = 5;
        for (Segment side : sides) {
            double x1 = side.x1Meters();
            double y1 = side.y1Meters();
            double x2 = side.x2Meters();
            double y2 = side.y2Meters();
            if (Distances.alongRay(robot.xMeters(), robot.yMeters(), armX / arm, armY / arm, x1, y1, x2, y2) < arm) {
                return 0.1;
            }
            nearest = Math.min(nearest, cone.distanceToSegment(x1, y1, x2, y2));
        }
        return Math.max(0.1, nearest);
    }

    private static void assertSonarsMeasureWhatIsThere(Simulation simulation, int checks, int every) {
        for (int check = 0; check < checks; check++) {
            simulation.run(37);
            for (int i = check % every; i < simulation.robots().size(); i += every) {
                SimulatedRobot robot = simulation.robots().get(i);
                List<Segment> sides = sidesAround(simulation, robot);
                double[] ranges = robot.sonarRangesMeters();
                for (int sonar = 0; sonar < SonarRing.COUNT; sonar++) {
                    assertEquals(
                            rangeOneByOne(sides, robot, sonar),
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
            for (Segment wall : world.segments()) {
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
                    world.homes().get(i).position().xMeters(),
                    simulation.robots().get(i).xMeters());
        }
        simulation.step();
    }
}
