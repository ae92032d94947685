package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import simrobot.robot.Trapezoid;
import simrobot.world.MapReader;
import simrobot.world.World;
import simrobot.world.WorldReader;
import vericommand.MotionOutcome;
import vericommand.MotionOutcome.Ending;
import vericommand.RobotStatus;

class TreadmillTest {
    private static World belt(String cairn, String... walls) throws Exception {
        return MapReader.read(
                "belt.map", "2D-Map\nCairn: Sim.Treadmill 0 0 " + cairn + "\nLINES\n" + String.join("\n", walls));
    }

    @Test
    void aBeltAgainstTheWheelsMakesAnInfiniteLoopAfterThreeTimesTheNominalTimeAndTwoSeconds() throws Exception {
        Bench bench = new Bench(belt("0 \"\" ICON \"v=-300\" -5000 -1000 5000 1000"), 0, 0, 0).forward(20);
        MotionOutcome outcome = bench.untilEnded();
        assertEquals(Ending.INFINITE_LOOP, outcome.ending());
        double limit = 3 * Trapezoid.FORWARD.seconds(0.2) + 2;
        assertEquals(limit, bench.simulation.timeNanos() * 1e-9, 0.0101);
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.STOPPED), bench.statuses);
        assertEquals(0, bench.robot.speedMetersPerSecond());
    }

    @Test
    void ourTreadmillWorldMakesEveryForwardOrderOnToTheBeltAnInfiniteLoop() throws Exception {
        World world = WorldReader.read(Path.of("..", "worlds", "treadmill.map"));
        for (int centimeters : new int[] {10, 20, 100, 600}) {
            Bench bench = new Bench(world, 0, 0, 0).forward(centimeters);
            assertEquals(Ending.INFINITE_LOOP, bench.untilEnded().ending(), centimeters + " cm");
            assertEquals(0, bench.robot.xMeters(), 0.3);
        }
    }

    @Test
    void ourTreadmillWorldLetsTheRobotTurnAndLeave() throws Exception {
        World world = WorldReader.read(Path.of("..", "worlds", "treadmill.map"));
        Bench bench = new Bench(world, 0, 0, 0).turn(180);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertEquals(Ending.DONE, bench.forward(100).untilEnded().ending());
        assertEquals(-1, bench.robot.xMeters(), 1e-9);
    }

    @Test
    void aBeltThatHelpsLetsTheGoalBeReachedByTheTruePlace() throws Exception {
        Bench bench = new Bench(belt("0 \"\" ICON \"v=100\" -5000 -1000 5000 1000"), 0, 0, 0).forward(200);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertTrue(bench.simulation.timeNanos() * 1e-9 < Trapezoid.FORWARD.seconds(2));
        assertTrue(bench.robot.xMeters() >= 2 && bench.robot.xMeters() < 2.2);
        assertEquals(200, bench.outcomes.get(0).amountDone());
    }

    @Test
    void aBeltSidewaysDriftsTheRobotButForwardIsStillForward() throws Exception {
        Bench bench = new Bench(belt("90 \"\" ICON \"v=50\" -5000 -5000 5000 5000"), 0, 0, 0).forward(100);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertEquals(1, bench.robot.xMeters(), 1e-9);
        assertEquals(0.05 * bench.simulation.timeNanos() * 1e-9, bench.robot.yMeters(), 1e-9);
    }

    @Test
    void aBeltCarriesAStandingRobotAgainstAWallAndNoFurther() throws Exception {
        Bench bench = new Bench(belt("0 \"\" ICON \"v=300\" -5000 -1000 5000 1000", "1000 -2000 1000 2000"), 0, 0, 0);
        bench.seconds(1);
        assertEquals(0.3, bench.robot.xMeters(), 1e-9);
        bench.seconds(5);
        double gap = 1 - 0.25 - bench.robot.xMeters();
        assertTrue(gap >= 0 && gap < 1e-6, "gap " + gap);
        assertTrue(bench.statuses.isEmpty());
    }

    @Test
    void wheelsThatDriveAwayFromTheWallThatTheBeltPressesAgainstDoNotCollide() throws Exception {
        Bench bench = new Bench(belt("0 \"\" ICON \"v=100\" 400 -1000 5000 1000", "1000 -2000 1000 2000"), 0.5, 0, 180);
        bench.seconds(12);
        bench.forward(50);
        assertEquals(Ending.DONE, bench.untilEnded().ending());
        assertEquals(0.25, bench.robot.xMeters(), 1e-6);
    }

    @Test
    void aRobotWithoutPowerIsCarriedToo() throws Exception {
        Bench bench = new Bench(belt("0 \"\" ICON \"v=300\" -5000 -1000 5000 1000"), 0, 0, 0);
        bench.robot.setPower(false);
        bench.seconds(1);
        assertEquals(0.3, bench.robot.xMeters(), 1e-9);
    }
}
