package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.process.BehaviourKind;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SimulatedRobot;
import simrobot.robot.Trapezoid;
import simrobot.world.Area;
import simrobot.world.Contact;
import simrobot.world.MovingDisc;
import simrobot.world.ObstacleGrid;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;
import simrobot.world.WorldBuilder;

/** Where searches for contacts are left out, a search of everything finds none: at each step, for every robot. */
class FreeSpaceTest {
    private static final long STEP_NANOS = Simulation.STEP_NANOS;

    private final Random chance = new Random(5);
    private final List<SimulatedRobot> robots = new ArrayList<>();
    private World world = clutter(20);
    private final SimulatedFloor floor = new SimulatedFloor(world);
    private int contacts;

    private World clutter(int walls) {
        List<Segment> segments = new ArrayList<>();
        for (int i = 0; i < walls; i++) {
            double x = chance.nextDouble() * 20;
            double y = chance.nextDouble() * 20;
            segments.add(new Segment(x, y, x + chance.nextGaussian() * 2, y + chance.nextGaussian() * 2));
        }
        return World.of("clutter", segments);
    }

    private void populate(int count) {
        while (robots.size() < count) {
            double x = chance.nextDouble() * 20;
            double y = chance.nextDouble() * 20;
            if (floor.isFree(null, x, y)) {
                SimulatedRobot robot =
                        new SimulatedRobot("r" + robots.size(), robots.size(), floor, x, y, chance.nextDouble() * 6);
                floor.placed(robot);
                robots.add(robot);
            }
        }
    }

    private void step() {
        floor.beginStep(List.of());
        for (SimulatedRobot robot : robots) {
            robot.step(STEP_NANOS);
            double size = chance.nextInt(10) == 0 ? 0.4 : 0.01;
            compare(robot, chance.nextGaussian() * size, chance.nextGaussian() * size);
        }
    }

    /** The robot's own sweep against one over all walls and robots. */
    private void compare(SimulatedRobot robot, double dx, double dy) {
        double radius = Pioneer2Dx.RADIUS_METERS;
        MovingDisc walls = new MovingDisc(robot.xMeters(), robot.yMeters(), dx, dy, radius);
        for (Segment wall : world.obstacles()) {
            walls.addSegment(wall.x1Meters(), wall.y1Meters(), wall.x2Meters(), wall.y2Meters());
        }
        Contact first = walls.contact();
        for (SimulatedRobot other : robots) {
            if (other != robot) {
                MovingDisc disc = new MovingDisc(robot.xMeters(), robot.yMeters(), dx, dy, radius);
                disc.addDisc(other.xMeters(), other.yMeters(), radius);
                first = first.earlier(disc.contact());
            }
        }
        Contact swept = floor.sweep(robot, dx, dy).contact();
        assertEquals(first.touches(), swept.touches());
        assertEquals(first.fraction(), swept.fraction());
        contacts += first.touches() ? 1 : 0;
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 12, 40})
    void wanderersMeetWhatASearchOfEverythingMeets(int count) {
        populate(count);
        robots.forEach(robot -> robot.autonomy().begin(BehaviourKind.WANDER));
        for (int i = 0; i < 4000; i++) {
            step();
        }
        assertTrue(contacts > 0, "some paths end at an obstacle");
    }

    @Test
    void fastRobotsAndThoseThatArePutElsewhereAreMetToo() {
        populate(20);
        for (int i = 0; i < 4000; i++) {
            SimulatedRobot robot = robots.get(chance.nextInt(robots.size()));
            switch (chance.nextInt(8)) {
                case 0 -> {
                    robot.drive().setLimits(fast(), fast());
                    robot.drive().setSpeed(chance.nextGaussian() * 2);
                }
                case 1 -> robot.drive().setTurnSpeed(chance.nextGaussian() * 3);
                case 2 -> {
                    robot.brakeAtOnce();
                    robot.place(chance.nextDouble() * 20, chance.nextDouble() * 20, 0);
                }
                default -> {
                    // it goes on as it does
                }
            }
            step();
        }
        assertTrue(contacts > 100, contacts + " paths end at an obstacle");
    }

    private static Trapezoid fast() {
        return new Trapezoid(2.2, 20);
    }

    @Test
    void anotherWorldIsNotTakenForTheFormer() {
        populate(10);
        for (int i = 0; i < 10; i++) {
            robots.forEach(robot -> robot.drive().setSpeed(0.5));
            for (int k = 0; k < 100; k++) {
                step();
            }
            robots.forEach(SimulatedRobot::brakeAtOnce);
            world = clutter(20);
            floor.load(world, new ObstacleGrid(world));
            robots.forEach(robot -> robot.setPower(true));
        }
    }

    @Test
    void aBeltCarriesRobotsAgainstWhatIsThere() {
        World belts = new WorldBuilder("belts")
                .add(new Treadmill(new Area(5, 5, 15, 15, 0), 0.8, 0.5))
                .build();
        floor.load(belts, new ObstacleGrid(belts));
        world = belts;
        populate(30);
        for (int i = 0; i < 2000; i++) {
            step();
        }
    }
}
