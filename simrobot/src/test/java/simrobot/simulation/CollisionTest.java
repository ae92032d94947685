package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simrobot.robot.Placement;
import simrobot.robot.SimulatedRobot;
import simrobot.world.ObstacleGrid;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.MotionOutcome.Ending;
import vericommand.RobotStatus;

class CollisionTest {
    private static final double RADIUS = 0.25;
    private static final Segment WALL_AHEAD = new Segment(1, -3, 1, 3);

    /** A hundredth of the millimetre that is promised. */
    private static void assertTouching(double gap) {
        assertTrue(gap >= 0 && gap < 1e-6, "gap " + gap);
    }

    private static Bench inCollision() {
        Bench bench = Bench.withWalls(WALL_AHEAD).forward(300);
        bench.untilEnded();
        bench.statuses.clear();
        bench.outcomes.clear();
        return bench;
    }

    @Test
    void aWallAheadEndsTheMotionAtContact() {
        Bench bench = Bench.withWalls(WALL_AHEAD).forward(300);
        MotionOutcome outcome = bench.untilEnded();
        assertEquals(Ending.COLLISION, outcome.ending());
        assertEquals(75, outcome.amountDone(), 1e-4);
        assertTouching(1 - RADIUS - bench.robot.xMeters());
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.COLLISION), bench.statuses);
        assertEquals(0, bench.robot.speedMetersPerSecond());
        double x = bench.robot.xMeters();
        bench.seconds(1);
        assertEquals(x, bench.robot.xMeters());
    }

    @Test
    void aGoalThatLiesJustBeforeContactIsReached() {
        Bench bench = Bench.withWalls(new Segment(0.4501, -1, 0.4501, 1)).forward(20);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertEquals(0.2, bench.robot.xMeters(), 1e-9);
    }

    @Test
    void aGoalThatLiesBeyondContactByATenthOfAMillimetreIsACollision() {
        Bench bench = Bench.withWalls(new Segment(0.4499, -1, 0.4499, 1)).forward(20);
        assertEquals(Ending.COLLISION, bench.untilEnded().ending());
    }

    @Test
    void contactIsExactAtManyAnglesAndSpeedsAgainstWallsCornersAndPoints() {
        Random random = new Random(3);
        for (int i = 0; i < 300; i++) {
            double distance = 0.3 + 2 * random.nextDouble();
            double angle = 2 * Math.PI * random.nextDouble();
            double px = distance * Math.cos(angle);
            double py = distance * Math.sin(angle);
            Segment obstacle = i % 2 == 0
                    ? new Segment(px, py, px, py)
                    : new Segment(px, py, px + random.nextGaussian(), py + random.nextGaussian());
            World world = World.of("one", List.of(obstacle));
            ObstacleGrid grid = new ObstacleGrid(world);
            if (grid.clearance(0, 0, 1) < RADIUS + 0.01) {
                continue;
            }
            Bench bench = new Bench(world, 0, 0, Math.toDegrees(angle) + random.nextGaussian() * 3);
            bench.forward(500);
            MotionOutcome outcome = bench.untilEnded();
            if (outcome.ending() == Ending.COLLISION) {
                assertTouching(grid.clearance(bench.robot.xMeters(), bench.robot.yMeters(), 1) - RADIUS);
            }
        }
    }

    @Test
    void theFirstContactCountsInARoomFullOfPosts() {
        World posts = World.of(
                "posts",
                List.of(new Segment(2, 0.1, 2, 0.1), new Segment(1.9, -0.2, 1.9, -0.2), new Segment(2.1, -1, 2.1, 1)));
        Bench bench = new Bench(posts, 0, 0, 0).forward(500);
        bench.untilEnded();
        assertEquals(1.9 - Math.sqrt(RADIUS * RADIUS - 0.04), bench.robot.xMeters(), 1e-6);
    }

    @Test
    void turningNeverCollidesHoweverNarrowThePlace() {
        World cell = World.of(
                "cell",
                List.of(
                        new Segment(-0.2501, -0.2501, 0.2501, -0.2501),
                        new Segment(0.2501, -0.2501, 0.2501, 0.2501),
                        new Segment(0.2501, 0.2501, -0.2501, 0.2501),
                        new Segment(-0.2501, 0.2501, -0.2501, -0.2501)));
        Bench bench = new Bench(cell, 0, 0, 0).turn(360);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
    }

    // ---- the ways out of Collision
    // -----------------------------------------------------------------------------------

    @Test
    void aTurnAwayEndsInStopped() {
        Bench bench = inCollision().turn(90);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.STOPPED), bench.statuses);
        bench.forward(50);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertEquals(-0.5, bench.robot.yMeters(), 1e-9);
    }

    @Test
    void aTurnThatStillLooksAtTheWallEndsInCollisionAgain() {
        Bench bench = inCollision().turn(89);
        assertEquals(Ending.COLLISION, bench.untilEnded().ending());
        assertEquals(89, bench.outcomes.get(0).amountDone());
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.COLLISION), bench.statuses);
    }

    @Test
    void aTurnExactlyAlongTheWallIsFreeAndTheWayAlongItToo() {
        Bench bench = inCollision().turn(270);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        bench.forward(200);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertEquals(2, bench.robot.yMeters(), 1e-9);
    }

    @Test
    void anotherWallOneCentimetreAwayIsFreeAndNineMillimetresAreNot() {
        for (double gap : new double[] {0.01, 0.009}) {
            Segment below = new Segment(-3, -RADIUS - gap, 3, -RADIUS - gap);
            Bench bench = Bench.withWalls(WALL_AHEAD, below).forward(300);
            bench.untilEnded();
            bench.turn(90).untilEnded();
            assertEquals(gap == 0.01 ? RobotStatus.STOPPED : RobotStatus.COLLISION, bench.robot.status());
        }
    }

    @Test
    void aTurnInCollisionThatIsBrakedIsJudgedByTheSameRule() {
        Bench bench = inCollision().turn(360).seconds(0.3);
        bench.robot.brake();
        assertEquals(Ending.BRAKED, bench.untilEnded().ending());
        assertEquals(RobotStatus.COLLISION, bench.robot.status());
        bench.turn(180).untilEnded();
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void motorsOffAndOnWhileTouchingIsStoppedAndForwardEndsAfterNoWay() {
        Bench bench = inCollision();
        bench.robot.setMotors(false);
        bench.robot.setMotors(true);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        MotionOutcome outcome = bench.forward(50).untilEnded();
        assertEquals(Ending.COLLISION, outcome.ending());
        assertEquals(0, outcome.amountDone(), 1e-3);
        assertEquals(RobotStatus.COLLISION, bench.robot.status());
    }

    // ---- by hand
    // -----------------------------------------------------------------------------------------------------

    @Test
    void placingRefusesObstaclesAndMovingRobots() {
        Bench bench = Bench.withWalls(WALL_AHEAD);
        assertSame(Placement.OCCUPIED, bench.robot.place(0.76, 0, 0));
        assertSame(Placement.OUTSIDE, bench.robot.place(Double.NaN, 0, 0));
        assertSame(Placement.DONE, bench.robot.place(0.75, 0, 1));
        bench.turn(90);
        assertSame(Placement.MOVING, bench.robot.place(-1, 0, 0));
        assertEquals(0.75, bench.robot.xMeters());
    }

    @Test
    void aRobotLiftedOutOfCollisionIsStopped() {
        Bench bench = inCollision();
        assertSame(Placement.DONE, bench.robot.place(0, 0, 0));
        assertEquals(List.of(RobotStatus.STOPPED), bench.statuses);
    }

    // ---- robots
    // ------------------------------------------------------------------------------------------------------

    @Test
    void robotsTouchAtTwoRadii() {
        Bench bench = Bench.onBareFloor();
        SimulatedRobot other = bench.simulation.addRobot("other", new Position(2, 0.1), 0);
        assertEquals(Ending.COLLISION, bench.forward(500).untilEnded().ending());
        assertTouching(Math.hypot(2 - bench.robot.xMeters(), 0.1) - 2 * RADIUS);
        assertEquals(RobotStatus.STOPPED, other.status());
    }

    @Test
    void aMovingRobotThatIsRunIntoIsInCollisionToo() {
        Bench bench = Bench.onBareFloor();
        SimulatedRobot other = bench.simulation.addRobot("other", new Position(2, 0), Math.PI);
        List<MotionOutcome> others = new java.util.ArrayList<>();
        other.start(new Instruction.Forward(500), others::add);
        assertEquals(Ending.COLLISION, bench.forward(500).untilEnded().ending());
        assertEquals(Ending.COLLISION, others.get(0).ending());
        assertTouching(other.xMeters() - bench.robot.xMeters() - 2 * RADIUS);
    }

    @Test
    void aRobotThatIsTakenAwayIsNoObstacle() {
        Bench bench = Bench.onBareFloor();
        SimulatedRobot other = bench.simulation.addRobot("other", new Position(2, 0), 0);
        bench.simulation.removeRobot(other);
        assertEquals(Ending.DONE, bench.forward(500).untilEnded().ending());
    }

    @Test
    void noRobotEverOverlapsAnotherOrAWallInACrowdThatDrivesAtRandom() {
        World hall = World.of(
                "hall",
                List.of(
                        new Segment(-4, -4, 4, -4),
                        new Segment(4, -4, 4, 4),
                        new Segment(4, 4, -4, 4),
                        new Segment(-4, 4, -4, -4)));
        Simulation simulation = new Simulation(hall, 5);
        for (int i = 0; i < 30; i++) {
            simulation.addRobot("r" + i);
        }
        ObstacleGrid grid = new ObstacleGrid(hall);
        for (int step = 0; step < 3000; step++) {
            simulation.robots().forEach(robot -> drive(simulation, robot));
            simulation.step();
            if (step % 10 == 0) {
                assertApart(simulation, grid);
            }
        }
    }

    private static void drive(Simulation simulation, SimulatedRobot robot) {
        if (robot.status() == RobotStatus.STOPPED) {
            robot.start(new Instruction.Forward(1 + simulation.random().nextInt(400)), done -> {});
        } else if (robot.status() == RobotStatus.COLLISION) {
            robot.start(new Instruction.Turn(1 + simulation.random().nextInt(360)), done -> {});
        }
    }

    private static void assertApart(Simulation simulation, ObstacleGrid grid) {
        List<SimulatedRobot> robots = simulation.robots();
        for (SimulatedRobot a : robots) {
            assertTrue(grid.clearance(a.xMeters(), a.yMeters(), 1) >= RADIUS);
            for (SimulatedRobot b : robots) {
                assertTrue(a == b || Math.hypot(a.xMeters() - b.xMeters(), a.yMeters() - b.yMeters()) >= 2 * RADIUS);
            }
        }
    }
}
