package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simrobot.robot.Trapezoid;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome.Ending;
import vericommand.RobotStatus;

class DrivingTest {
    @Test
    void thePapersTwentyCentimetresAreTwentyCentimetres() {
        Bench bench = Bench.onBareFloor().forward(20);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertEquals(0.2, bench.robot.xMeters(), 1e-9);
        assertEquals(20, bench.outcomes.get(0).amountDone());
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.STOPPED), bench.statuses);
    }

    @Test
    void everyForwardInRangeEndsOnItsGoalInItsNominalTime() {
        double heading = 37;
        for (int n = 1; n <= 9999; n = n < 130 ? n + 1 : n + 97) {
            assertForward(n, heading);
        }
        assertForward(9998, heading);
        assertForward(9999, heading);
    }

    private static void assertForward(int n, double heading) {
        Bench bench = new Bench(World.bare(), 3, -2, heading).forward(n);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertEquals(3 + n / 100.0 * Math.cos(Math.toRadians(heading)), bench.robot.xMeters(), 1e-8, n + " cm");
        assertEquals(-2 + n / 100.0 * Math.sin(Math.toRadians(heading)), bench.robot.yMeters(), 1e-8, n + " cm");
        assertEquals(n, bench.outcomes.get(0).amountDone(), 1e-9);
        double nominal = Trapezoid.FORWARD.seconds(n / 100.0);
        assertEquals(nominal, bench.simulation.timeNanos() * 1e-9, 0.0101, n + " cm");
    }

    @Test
    void everyTurnInRangeEndsOnItsGoalClockwiseInItsNominalTime() {
        for (int n = 1; n <= 360; n++) {
            Bench bench = Bench.onBareFloor().turn(n);
            assertEquals(Ending.DONE, bench.untilEnded().ending());
            assertEquals((360 - n) % 360, bench.robot.pose().headingDegrees(), 1e-9);
            assertEquals(n, bench.outcomes.get(0).amountDone(), 1e-9);
            assertEquals(Trapezoid.TURN.seconds(Math.toRadians(n)), bench.simulation.timeNanos() * 1e-9, 0.0101);
        }
    }

    @Test
    void aThousandTurnsAndLegsBringItHomeExactly() {
        Bench bench = Bench.onBareFloor();
        for (int i = 0; i < 1000; i++) {
            bench.forward(7).untilEnded();
            bench.turn(90).untilEnded();
        }
        assertEquals(0, bench.robot.xMeters(), 1e-7);
        assertEquals(0, bench.robot.yMeters(), 1e-7);
        assertEquals(0, bench.robot.pose().headingDegrees(), 1e-9);
    }

    @Test
    void theWheelsMoveInTheFirstStepAfterTheOrder() {
        Bench bench = Bench.onBareFloor();
        int[] told = {0};
        bench.robot.addFirstMotionListener(() -> told[0]++);
        bench.forward(20);
        assertEquals(0, told[0]);
        bench.simulation.step();
        assertEquals(1, told[0]);
        assertTrue(bench.robot.xMeters() > 0);
        bench.untilEnded();
        assertEquals(1, told[0]);
    }

    @Test
    void topSpeedIsHalfAMetrePerSecond() {
        Bench bench = Bench.onBareFloor().forward(1000).seconds(5);
        assertEquals(0.5, bench.robot.speedMetersPerSecond(), 1e-12);
        assertEquals(RobotStatus.MOVING, bench.robot.status());
    }

    @Test
    void aTurnRunsAtNinetyDegreesPerSecondClockwise() {
        Bench bench = Bench.onBareFloor().turn(360).seconds(2);
        assertEquals(-Math.PI / 2, bench.robot.turnRadiansPerSecond(), 1e-12);
    }

    // ---- brake -----------------------------------------------------------------------------------------------------

    @Test
    void aBrakeTakesTheRobotsDecelerationAndStaysMovingUntilItStands() {
        Bench bench = Bench.onBareFloor().forward(1000).seconds(5);
        double before = bench.robot.xMeters();
        bench.robot.brake();
        assertEquals(RobotStatus.MOVING, bench.robot.status());
        bench.seconds(1.6);
        assertEquals(RobotStatus.MOVING, bench.robot.status());
        assertEquals(Ending.BRAKED, bench.untilEnded().ending());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertEquals(before + 0.5 * 0.5 / 0.6, bench.robot.xMeters(), 1e-9);
        assertEquals(bench.robot.xMeters() * 100, bench.outcomes.get(0).amountDone(), 1e-9);
    }

    @Test
    void aBrakeStopsATurnToo() {
        Bench bench = Bench.onBareFloor().turn(360).seconds(2);
        bench.robot.brake();
        assertEquals(Ending.BRAKED, bench.untilEnded().ending());
        assertTrue(bench.outcomes.get(0).amountDone() < 200);
        assertEquals(0, bench.robot.turnRadiansPerSecond());
    }

    @Test
    void aBrakeBeforeTheFirstStepEndsTheMotionWhereItBegan() {
        Bench bench = Bench.onBareFloor().forward(100);
        bench.robot.brake();
        assertEquals(Ending.BRAKED, bench.untilEnded().ending());
        assertEquals(0, bench.robot.xMeters());
    }

    @Test
    void aBrakeOfAStandingRobotDoesNothing() {
        Bench bench = Bench.onBareFloor();
        bench.robot.brake();
        bench.seconds(1);
        assertTrue(bench.statuses.isEmpty());
    }

    // ---- switches
    // ----------------------------------------------------------------------------------------------------

    @Test
    void motorsOffStandsStillAtOnceAndAborts() {
        Bench bench = Bench.onBareFloor().forward(1000).seconds(3);
        double x = bench.robot.xMeters();
        bench.robot.setMotors(false);
        assertEquals(Ending.ABORTED, bench.outcomes.get(0).ending());
        assertEquals(x * 100, bench.outcomes.get(0).amountDone(), 1e-9);
        bench.seconds(1);
        assertEquals(x, bench.robot.xMeters());
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.NO_MOTORS), bench.statuses);
    }

    @Test
    void powerOffAbortsAndPowerOnLeavesTheMotorsOff() {
        Bench bench = Bench.onBareFloor().turn(90).seconds(0.5);
        bench.robot.setPower(false);
        assertEquals(Ending.ABORTED, bench.outcomes.get(0).ending());
        bench.robot.setMotors(true);
        assertEquals(RobotStatus.DISCONNECTED, bench.robot.status());
        bench.robot.setPower(true);
        assertEquals(RobotStatus.NO_MOTORS, bench.robot.status());
        bench.robot.setMotors(true);
        assertEquals(
                List.of(RobotStatus.MOVING, RobotStatus.DISCONNECTED, RobotStatus.NO_MOTORS, RobotStatus.STOPPED),
                bench.statuses);
    }

    @Test
    void aSwitchThatIsThereAlreadyChangesNothing() {
        Bench bench = Bench.onBareFloor();
        bench.robot.setPower(true);
        bench.robot.setMotors(true);
        assertTrue(bench.statuses.isEmpty());
        assertTrue(bench.robot.isPowered() && bench.robot.hasMotors());
    }

    @Test
    void noMotionStartsWhereTheStatusForbidsIt() {
        Bench bench = Bench.onBareFloor();
        bench.robot.setMotors(false);
        assertThrows(IllegalStateException.class, () -> bench.forward(20));
        bench.robot.setPower(false);
        assertThrows(IllegalStateException.class, () -> bench.turn(20));
        bench.robot.setPower(true);
        bench.robot.setMotors(true);
        bench.forward(20);
        assertThrows(IllegalStateException.class, () -> bench.forward(20));
    }

    @Test
    void theNextMotionMayStartWhileTheLastOneIsReported() {
        Bench bench = Bench.onBareFloor();
        bench.robot.start(new Instruction.Forward(10), first -> bench.turn(90));
        bench.untilEnded();
        assertEquals(0.1, bench.robot.xMeters(), 1e-9);
        assertEquals(270, bench.robot.pose().headingDegrees());
        assertEquals(
                List.of(RobotStatus.MOVING, RobotStatus.STOPPED, RobotStatus.MOVING, RobotStatus.STOPPED),
                bench.statuses);
    }
}
