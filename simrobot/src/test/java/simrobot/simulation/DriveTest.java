package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.robot.Bumpers;
import simrobot.robot.Placement;
import simrobot.robot.Trapezoid;
import simrobot.world.ObstacleGrid;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;

class DriveTest {
    private static final Segment WALL_AHEAD = new Segment(1, -3, 1, 3);
    private static final Segment WALL_BEHIND = new Segment(-1, -3, -1, 3);

    private static void assertTouching(double gap) {
        assertTrue(gap >= 0 && gap < 1e-6, "gap " + gap);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.5, -0.3, -0.4, -0.197, 0.001, 12.345, -32.767})
    void aMoveEndsExactlyThereAheadAndBack(double way) {
        Bench bench = Bench.onBareFloor();
        bench.robot.drive().move(way);
        bench.seconds(60);
        assertEquals(way, bench.robot.xMeters(), 1e-9);
        assertEquals(way, bench.robot.odometry().xMeters(), 1e-9);
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.STOPPED), bench.statuses);
    }

    @ParameterizedTest
    @ValueSource(doubles = {90, -90, 1, 360, -0.1, 179.5})
    void aTurnEndsExactlyThere(double degrees) {
        Bench bench = Bench.onBareFloor();
        bench.robot.drive().turn(Math.toRadians(degrees));
        bench.seconds(20);
        assertEquals(degrees, Math.toDegrees(bench.robot.headingRadians()), 1e-7);
        assertEquals(0, Math.hypot(bench.robot.xMeters(), bench.robot.yMeters()));
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.STOPPED), bench.statuses);
    }

    @Test
    void aMoveThatIsChangedOnTheWayIsExactFromWhereItWasChanged() {
        Bench bench = Bench.onBareFloor();
        bench.robot.drive().setSpeed(0.4);
        bench.seconds(3);
        double from = bench.robot.xMeters();
        bench.robot.drive().move(-0.5);
        bench.seconds(10);
        assertEquals(from - 0.5, bench.robot.xMeters(), 1e-9);
    }

    @Test
    void gainingAndLosingSpeedKeepTheirOwnLimits() {
        Bench bench = Bench.onBareFloor();
        bench.robot
                .drive()
                .setLimits(new Trapezoid(0.2, 0.1, 0.4), bench.robot.drive().turnLimits());
        bench.robot.drive().setSpeed(0.5);
        bench.seconds(1);
        assertEquals(0.1, bench.robot.speedMetersPerSecond(), 1e-9);
        bench.seconds(2);
        assertEquals(0.2, bench.robot.speedMetersPerSecond(), 1e-9);
        double from = bench.robot.xMeters();
        bench.robot.brake();
        bench.seconds(0.25);
        assertEquals(0.1, bench.robot.speedMetersPerSecond(), 1e-9);
        bench.seconds(0.5);
        assertEquals(0.2 * 0.2 / 0.8, bench.robot.xMeters() - from, 1e-9);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void aMoveWithUnequalLimitsIsExactToo() {
        Bench bench = Bench.onBareFloor();
        bench.robot
                .drive()
                .setLimits(new Trapezoid(0.7, 0.15, 0.6), bench.robot.drive().turnLimits());
        bench.robot.drive().move(1.234);
        bench.seconds(20);
        assertEquals(1.234, bench.robot.xMeters(), 1e-9);
    }

    @Test
    void aLoweredTopSpeedIsReachedByLosingSpeedAndTheGoalIsStillExact() {
        Bench bench = Bench.onBareFloor();
        bench.robot.drive().move(3);
        bench.seconds(2);
        bench.robot
                .drive()
                .setLimits(new Trapezoid(0.1, 0.3), bench.robot.drive().turnLimits());
        bench.seconds(2);
        assertEquals(0.1, bench.robot.speedMetersPerSecond(), 1e-9);
        bench.seconds(60);
        assertEquals(3, bench.robot.xMeters(), 1e-9);
    }

    @Test
    void goingAndTurningAtOnceIsACircle() {
        Bench bench = Bench.onBareFloor();
        Trapezoid atOnce = new Trapezoid(10, 1e9);
        bench.robot.drive().setLimits(atOnce, atOnce);
        bench.robot.drive().setSpeed(0.5);
        bench.robot.drive().setTurnSpeed(Math.toRadians(90));
        bench.seconds(1);
        double radius = 0.5 / Math.toRadians(90);
        assertEquals(radius, bench.robot.xMeters(), 1e-6);
        assertEquals(radius, bench.robot.yMeters(), 1e-6);
        assertEquals(radius, bench.robot.odometry().yMeters(), 1e-6);
        bench.seconds(3);
        assertEquals(0, Math.hypot(bench.robot.xMeters(), bench.robot.yMeters()), 1e-6);
    }

    @ParameterizedTest
    @CsvSource({"2.5, 0.75", "-2.5, -0.75"})
    void contactAheadAndBehindIsExactAndIsCollision(double way, double end) {
        Bench bench = Bench.withWalls(WALL_AHEAD, WALL_BEHIND);
        bench.robot.drive().move(way);
        bench.seconds(10);
        assertTouching(Math.abs(end) - Math.abs(bench.robot.xMeters()));
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.COLLISION), bench.statuses);
        assertEquals(0, bench.robot.speedMetersPerSecond());
        assertEquals(way > 0 ? new Bumpers(0b00100, 0) : new Bumpers(0, 0b00100), bench.robot.bumpers());
    }

    @Test
    void contactOnArcsIsExact() {
        Random random = new Random(11);
        for (int i = 0; i < 200; i++) {
            double distance = 0.3 + random.nextDouble();
            double angle = 2 * Math.PI * random.nextDouble();
            double px = distance * Math.cos(angle);
            double py = distance * Math.sin(angle);
            Segment obstacle = new Segment(px, py, px + random.nextGaussian(), py + random.nextGaussian());
            World world = World.of("one", List.of(obstacle));
            ObstacleGrid grid = new ObstacleGrid(world);
            if (grid.clearance(0, 0, 1) < 0.26) {
                continue;
            }
            Bench bench = new Bench(world, 0, 0, Math.toDegrees(angle));
            bench.robot.drive().setSpeed(random.nextBoolean() ? 2 : -2);
            bench.robot.drive().setTurnSpeed(random.nextGaussian() * 2);
            for (int step = 0; step < 1500; step++) {
                bench.simulation.step();
                double gap = grid.clearance(bench.robot.xMeters(), bench.robot.yMeters(), 1) - 0.25;
                assertTrue(gap >= 0, "run " + i + " gap " + gap);
                if (bench.robot.status() == RobotStatus.COLLISION) {
                    assertTouching(gap);
                    break;
                }
            }
        }
    }

    @Test
    void whoHasCollidedBacksAwayAndIsStoppedWhenItStandsFree() {
        Bench bench = Bench.withWalls(WALL_AHEAD);
        bench.robot.drive().move(3);
        bench.seconds(10);
        bench.statuses.clear();
        bench.robot.drive().move(-0.2);
        bench.seconds(5);
        assertEquals(0.55, bench.robot.xMeters(), 1e-6);
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.STOPPED), bench.statuses);
        assertEquals(new Bumpers(0, 0), bench.robot.bumpers());
    }

    @Test
    void aCollidedRobotDoesNotPushOnHoweverOftenItIsOrdered() {
        Bench bench = Bench.withWalls(WALL_AHEAD);
        bench.robot.drive().move(3);
        bench.seconds(10);
        double x = bench.robot.xMeters();
        bench.statuses.clear();
        for (int i = 0; i < 10; i++) {
            bench.robot.drive().setSpeed(0.2);
            bench.seconds(0.1);
        }
        assertEquals(List.of(), bench.statuses);
        assertEquals(x, bench.robot.xMeters());
    }

    @Test
    void aTurnInCollisionThatLeavesTheWayBlockedEndsInCollision() {
        Bench bench = Bench.withWalls(WALL_AHEAD);
        bench.robot.drive().move(3);
        bench.seconds(10);
        bench.robot.drive().turn(Math.toRadians(30));
        bench.seconds(5);
        assertEquals(RobotStatus.COLLISION, bench.robot.status());
        assertEquals(new Bumpers(0b01000, 0), bench.robot.bumpers());
        bench.robot.drive().turn(Math.toRadians(90));
        bench.seconds(5);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void withoutMotorsTargetsAreForgotten() {
        Bench bench = Bench.onBareFloor();
        bench.robot.setMotors(false);
        bench.robot.drive().setSpeed(0.3);
        bench.seconds(1);
        bench.robot.setMotors(true);
        bench.seconds(1);
        assertEquals(0, bench.robot.xMeters());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void motorsOffStopAtOnce() {
        Bench bench = Bench.onBareFloor();
        bench.robot.drive().setSpeed(0.3);
        bench.seconds(1);
        double x = bench.robot.xMeters();
        bench.robot.setMotors(false);
        bench.seconds(1);
        assertEquals(x, bench.robot.xMeters());
        assertEquals(RobotStatus.NO_MOTORS, bench.robot.status());
    }

    @Test
    void aSuspendedDriveStandsStoppedAndGoesOnToItsGoal() {
        Bench bench = Bench.onBareFloor();
        bench.robot.drive().move(2);
        bench.seconds(2);
        bench.robot.drive().setSuspended(true);
        bench.seconds(5);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertTrue(bench.robot.xMeters() < 1.5);
        bench.robot.drive().setSuspended(false);
        bench.seconds(20);
        assertEquals(2, bench.robot.xMeters(), 1e-9);
    }

    @Test
    void brakingAtOnceLeavesNoWay() {
        Bench bench = Bench.onBareFloor();
        bench.robot.drive().setSpeed(0.5);
        bench.seconds(3);
        double x = bench.robot.xMeters();
        bench.robot.brakeAtOnce();
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        bench.seconds(1);
        assertEquals(x, bench.robot.xMeters());
    }

    @Test
    void brakingAtOnceEndsAnOrderAsBraked() {
        Bench bench = Bench.onBareFloor().forward(300);
        bench.seconds(2);
        bench.robot.brakeAtOnce();
        assertEquals(MotionOutcome.Ending.BRAKED, bench.outcomes.get(0).ending());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void anOrderMovesTheOdometryToo() {
        Bench bench = Bench.onBareFloor().forward(100);
        bench.untilEnded();
        bench.turn(90).untilEnded();
        assertEquals(1, bench.robot.odometry().xMeters(), 1e-9);
        assertEquals(-90, Math.toDegrees(bench.robot.odometry().headingRadians()), 1e-9);
        assertFalse(bench.robot.isUnderOrder());
    }

    @Test
    void draggingTheRobotLeavesTheOdometry() {
        Bench bench = Bench.onBareFloor();
        bench.robot.drive().move(0.5);
        bench.seconds(5);
        assertEquals(Placement.DONE, bench.robot.place(3, 4, 1));
        assertEquals(0.5, bench.robot.odometry().xMeters(), 1e-9);
        assertEquals(0, bench.robot.odometry().headingRadians(), 1e-9);
    }
}
