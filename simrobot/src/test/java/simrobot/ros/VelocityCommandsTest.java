package simrobot.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simrobot.robot.DirectControl;
import simrobot.robot.Drive;
import simrobot.robot.SimulatedRobot;
import simrobot.robot.Trapezoid;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.RobotStatus;

/** Velocities of ROS clients, with both clocks in the test's hand. */
class VelocityCommandsTest {
    private static final Object ANN = "ann";
    private static final Object BEN = "ben";

    private final Simulation simulation = new Simulation(World.bare(), 1);
    private final SimulatedRobot robot = simulation.addRobot("robot", new Position(0, 0), 0);
    private final VelocityCommands velocities = new VelocityCommands();
    private long nanos = 77_000_000_000L;

    VelocityCommandsTest() {
        simulation.addStepListener(simulated -> velocities.tick(nanos += Simulation.STEP_NANOS));
    }

    private Optional<String> drive(Object client, double metersPerSecond, double radiansPerSecond) {
        return velocities.drive(robot, client, new Twist(metersPerSecond, radiansPerSecond), nanos);
    }

    @Test
    void aVelocityIsReachedWithTheRobotsAccelerationAndHeldWhileItIsRepeated() {
        for (int i = 0; i < 20; i++) {
            assertEquals(Optional.empty(), drive(ANN, 0.2, 0.1));
            simulation.run(10);
        }
        assertEquals(0.2, robot.speedMetersPerSecond(), 1e-9);
        assertEquals(0.1, robot.turnRadiansPerSecond(), 1e-9);
        assertEquals(RobotStatus.MOVING, robot.status());
    }

    @ParameterizedTest
    @CsvSource({"49, 0.147", "50, 0.15", "51, 0.147", "60, 0.12", "100, 0"})
    void halfASecondAfterTheLastVelocityTheRobotBrakes(int steps, double metersPerSecond) {
        drive(ANN, 0.5, 0);
        simulation.run(steps);
        assertEquals(metersPerSecond, robot.speedMetersPerSecond(), 1e-9);
    }

    @Test
    void theRobotBrakesAtOnceWhenTheClientThatDrivesItEnds() {
        drive(ANN, 0.5, 0);
        simulation.run(20);
        velocities.release(BEN);
        simulation.run(10);
        assertEquals(0.09, robot.speedMetersPerSecond(), 1e-9);
        velocities.release(ANN);
        simulation.run(10);
        assertEquals(0.06, robot.speedMetersPerSecond(), 1e-9);
        simulation.run(30);
        assertEquals(RobotStatus.STOPPED, robot.status());
    }

    @Test
    void theLastClientDrivesAndTheEndOfTheOtherIsWithoutEffect() {
        drive(ANN, 0.5, 0);
        drive(BEN, -0.5, 0);
        velocities.release(ANN);
        simulation.run(10);
        assertEquals(-0.03, robot.speedMetersPerSecond(), 1e-9);
    }

    @Test
    void anOrderInProgressWins() {
        robot.start(new Instruction.Forward(100), outcome -> {});
        simulation.run(10);
        assertEquals(
                "robot robot executes an order, its velocity cannot be set",
                drive(ANN, 0, 0).orElseThrow());
        simulation.run(1000);
        assertEquals(1, robot.xMeters(), 1e-9);
        assertEquals(Optional.empty(), drive(ANN, 0.1, 0));
    }

    @Test
    void theWatchdogDoesNotBrakeAnOrderThatFollows() {
        drive(ANN, 0.01, 0);
        simulation.run(10);
        velocities.release(ANN);
        simulation.run(20);
        drive(ANN, 0, 0);
        robot.start(new Instruction.Forward(100), outcome -> {});
        simulation.run(1000);
        assertTrue(robot.xMeters() > 1, "place " + robot.xMeters());
    }

    @Test
    void withoutMotorsAVelocityIsRefused() {
        robot.setMotors(false);
        assertEquals(
                "robot robot has no power or motors, its velocity cannot be set",
                drive(ANN, 0.1, 0).orElseThrow());
    }

    @Test
    void whatAnotherProgramSetAndSuspendedDoesNotHoldTheRobotBack() {
        DirectControl other = new DirectControl(robot);
        other.begin();
        robot.drive().setLimits(new Trapezoid(0.01, 0.01), Drive.TURN_LIMITS);
        other.setSuspended(true);
        drive(ANN, 0.1, 0);
        simulation.run(40);
        assertEquals(0.1, robot.speedMetersPerSecond(), 1e-9);
    }
}
