package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simrobot.process.BehaviourKind;
import simrobot.robot.Battery;
import simrobot.robot.Bumpers;
import simrobot.robot.LaserField;
import simrobot.robot.SimulatedRobot;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.RobotStatus;

/** Bumpers, battery, and what wheels and sonars get wrong. */
class SensesTest {
    private static final World CORNER = World.of("corner", List.of(new Segment(2, -5, 2, 5), new Segment(-5, 1, 5, 1)));

    private static Simulation simulation(World world, double noise, long seed) {
        Simulation simulation = new Simulation(world, seed);
        simulation.setNoise(noise);
        return simulation;
    }

    private static SimulatedRobot robot(Simulation simulation) {
        return simulation.addRobot("robot", new Position(0, 0), 0);
    }

    // ---- laser -----------------------------------------------------------------------------------------------------

    @Test
    void theLaserSeesWallsAndRobotsUpTo32MetersAway() {
        Simulation simulation = simulation(World.of("far walls", List.of(new Segment(-50, 30, 50, 30))), 0, 1);
        SimulatedRobot robot = robot(simulation);
        simulation.addRobot("other", new Position(20, 0), 0);
        robot.sonarRangesMeters();
        double[] ranges = robot.laser().rangesMeters(LaserField.USUAL);
        assertEquals(181, ranges.length);
        assertEquals(20 - 0.04 - 0.22 - 0.018, ranges[90], 1e-9, "the other robot's back");
        assertEquals(30, ranges[180], 1e-9, "the wall at the left");
        assertEquals(30 / Math.cos(Math.toRadians(10)), ranges[170], 1e-9);
        assertEquals(32, ranges[0], "nothing at the right");
        assertEquals(32, ranges[140], "the wall is farther than 32 m there");
    }

    @Test
    void aNoisyLaserScattersBy5MillimetersAndTheSameSeedAndStepReadTheSame() {
        World walls = World.of("walls", List.of(new Segment(-2, 3, 2, 3)));
        Simulation simulation = simulation(walls, 1, 2);
        SimulatedRobot robot = robot(simulation);
        SimulatedRobot twin = robot(simulation(walls, 1, 2));
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < 1000; i++) {
            double error = robot.laserMeters(180) - 3;
            assertEquals(robot.laserMeters(180), robot.laserMeters(180));
            sum += error;
            squares += error * error;
            assertEquals(32, robot.laserMeters(0), "without an echo there is no error");
            simulation.step();
        }
        assertEquals(0, sum / 1000, 0.0005);
        assertEquals(0.005, Math.sqrt(squares / 1000), 0.0005);
        assertEquals(twin.laserMeters(90), robot(simulation(walls, 1, 2)).laserMeters(90));
        assertNotEquals(twin.laserMeters(180), robot(simulation(walls, 1, 3)).laserMeters(180));
    }

    // ---- bumpers ---------------------------------------------------------------------------------------------------

    @ParameterizedTest
    @CsvSource({
        "90, 1, 0",
        "54.1, 1, 0",
        "53.9, 2, 0",
        "18.1, 2, 0",
        "17.9, 4, 0",
        "0, 4, 0",
        "-17.9, 4, 0",
        "-18.1, 8, 0",
        "-54.1, 16, 0",
        "-89.9, 16, 0",
        "-90.1, 0, 1",
        "-126.1, 0, 2",
        "-162.1, 0, 4",
        "180, 0, 4",
        "162.1, 0, 4",
        "161.9, 0, 8",
        "125.9, 0, 16",
        "90.1, 0, 16"
    })
    void theBumperWhereItTouchesIsPressed(double bearingDegrees, int front, int rear) {
        Simulation simulation = simulation(World.of("wall", List.of(new Segment(1, -5, 1, 5))), 0, 1);
        SimulatedRobot robot = robot(simulation);
        robot.drive().move(3);
        simulation.run(1000);
        robot.drive().turn(Math.toRadians(-bearingDegrees));
        simulation.run(1000);
        assertEquals(new Bumpers(front, rear), robot.bumpers());
        assertEquals(
                robot.bumpers(),
                simulation.snapshot().robots().get(0).condition().bumpers());
    }

    @Test
    void inACornerBothWallsPress() {
        Simulation simulation = simulation(CORNER, 0, 1);
        SimulatedRobot robot = robot(simulation);
        robot.place(1, 0.7499, 0);
        robot.drive().move(3);
        simulation.run(1000);
        assertEquals(RobotStatus.COLLISION, robot.status());
        assertEquals(new Bumpers(0b00101, 0), new Bumpers(robot.bumpers().front() | 1, 0));
        assertTrue(
                robot.bumpers().front() != 0b00100 || robot.bumpers().rear() != 0, "the wall beside it presses, too");
    }

    @Test
    void aRobotThatStandsBesideAWallAndHasTouchedNothingPressesNothing() {
        Simulation simulation = simulation(CORNER, 0, 1);
        SimulatedRobot robot = robot(simulation);
        robot.place(0, 0.7495, 0);
        assertEquals(new Bumpers(0, 0), robot.bumpers());
    }

    @Test
    void bothRobotsFeelThatTheyHaveMet() {
        Simulation simulation = simulation(World.bare(), 0, 1);
        SimulatedRobot one = robot(simulation);
        SimulatedRobot other = simulation.addRobot("other", new Position(2, 0), Math.PI / 2);
        one.drive().move(3);
        simulation.run(1000);
        assertEquals(new Bumpers(0b00100, 0), one.bumpers());
        assertEquals(
                1, Integer.bitCount(other.bumpers().front() | other.bumpers().rear() << 5));
    }

    // ---- battery ---------------------------------------------------------------------------------------------------

    @Test
    void theBatteryDrainsFasterWhileItDrivesAndIsFullWhenSwitchedOnAgain() {
        Simulation simulation = simulation(World.bare(), 0, 1);
        SimulatedRobot robot = robot(simulation);
        assertEquals(Battery.FULL_VOLTS, robot.battery().volts());
        simulation.run(10_000);
        double standing = Battery.FULL_VOLTS - robot.battery().volts();
        robot.drive().setTurnSpeed(2);
        simulation.run(10_000);
        double turning = Battery.FULL_VOLTS - standing - robot.battery().volts();
        assertTrue(standing > 0 && turning > 2 * standing, standing + " and " + turning);
        robot.setPower(false);
        simulation.run(100);
        robot.setPower(true);
        assertEquals(Battery.FULL_VOLTS, robot.battery().volts());
    }

    @Test
    void aDayOfStandingLeavesItLowButNotDead() {
        Simulation simulation = simulation(World.bare(), 0, 1);
        SimulatedRobot robot = robot(simulation);
        for (int i = 0; i < 24 * 60; i++) {
            robot.step(60_000_000_000L);
        }
        assertTrue(robot.battery().isLow());
        assertEquals(10.5, robot.battery().volts(), 1e-9);
        robot.start(new Instruction.Forward(20), outcome -> {});
        simulation.run(500);
        assertEquals(0.2, robot.xMeters(), 1e-9);
    }

    // ---- noise -----------------------------------------------------------------------------------------------------

    @Test
    void withoutNoiseTheOdometryIsTheTruth() {
        Simulation simulation = simulation(World.bare(), 0, 5);
        SimulatedRobot robot = robot(simulation);
        robot.start(new Instruction.Forward(300), outcome -> {});
        simulation.run(2000);
        assertEquals(3, robot.xMeters(), 1e-9);
        assertEquals(3, robot.odometry().xMeters(), 1e-9);
    }

    @Test
    void withNoiseAnOrderIsStillExactInTruthAndTheOdometryErrsAtMostThatMuch() {
        int wrong = 0;
        for (long seed = 0; seed < 20; seed++) {
            Simulation simulation = simulation(World.bare(), 1, seed);
            SimulatedRobot robot = robot(simulation);
            robot.start(new Instruction.Forward(300), outcome -> {});
            simulation.run(2000);
            assertEquals(3, robot.xMeters(), 1e-9);
            double error = robot.odometry().xMeters() - 3;
            assertTrue(Math.abs(error) <= 3 * 0.0076, "error " + error);
            wrong += Math.abs(error) > 0.001 ? 1 : 0;
        }
        assertTrue(wrong > 10, wrong + " of 20 robots err by more than a millimetre");
    }

    @Test
    void aDrivenRobotCountsByItsWheelsAndErrsInTruth() {
        Simulation simulation = simulation(World.bare(), 4, 3);
        SimulatedRobot robot = robot(simulation);
        robot.drive().move(2);
        simulation.run(2000);
        assertEquals(2, robot.odometry().xMeters(), 1e-9);
        assertNotEquals(2, robot.xMeters(), 1e-4);
        assertEquals(2, robot.xMeters(), 2 * 0.031);
    }

    @Test
    void theSameSeedErrsInTheSameWayHoweverOftenTheSonarsAreLookedAt() {
        double[][] heard = new double[2][];
        double[] odometry = new double[2];
        for (int run = 0; run < 2; run++) {
            Simulation simulation = simulation(CORNER, 1, 9);
            SimulatedRobot robot = robot(simulation);
            robot.drive().move(0.5);
            for (int i = 0; i < 500; i++) {
                simulation.step();
                for (int look = 0; look < run; look++) {
                    robot.sonarRangesMeters();
                }
            }
            heard[run] = robot.sonarRangesMeters();
            odometry[run] = robot.xMeters();
        }
        assertArrayEquals(heard[0], heard[1]);
        assertEquals(odometry[0], odometry[1]);
    }

    @Test
    void noisySonarsScatterAboutTheTruthAndNoEchoStaysNone() {
        Simulation simulation = simulation(CORNER, 1, 2);
        SimulatedRobot robot = robot(simulation);
        double[] exact = robot(simulation(CORNER, 0, 2)).sonarRangesMeters();
        double sum = 0;
        double most = 0;
        for (int i = 0; i < 400; i++) {
            simulation.run(32); // a turn of all sonars
            double error = robot.sonarRangesMeters()[3] - exact[3];
            sum += error;
            most = Math.max(most, Math.abs(error));
            assertEquals(5, robot.sonarRangesMeters()[11]);
        }
        assertTrue(most > 0.003 && most < 0.025, "most " + most);
        assertEquals(0, sum / 400, 0.002);
    }

    // ---- sonars that fire in turn ----------------------------------------------------------------------------------

    /** After each 40 ms the ranges of one sonar of each array are new, in the order of their numbers. */
    @Test
    void oneSonarOfEachArrayFiresEvery40Milliseconds() {
        Simulation simulation = simulation(CORNER, 0, 1);
        SimulatedRobot robot = robot(simulation);
        robot.drive().setTurnSpeed(0.5);
        simulation.run(100);
        List<List<Integer>> fired = new ArrayList<>();
        double[] before = robot.sonarRangesMeters();
        for (int step = 101; step <= 164; step++) {
            simulation.step();
            double[] after = robot.sonarRangesMeters();
            for (int sonar = 0; sonar < 8; sonar++) {
                boolean isNew = after[sonar] != before[sonar] || after[sonar + 8] != before[sonar + 8];
                if (isNew) {
                    fired.add(List.of(step, sonar));
                }
            }
            before = after;
        }
        for (List<Integer> firing : fired) {
            int step = firing.get(0);
            assertEquals(List.of(step / 4 * 4, step / 4 % 8), firing);
        }
        assertTrue(fired.size() > 8, "walls are seen by some sonar: " + fired);
    }

    @Test
    void whatIsPutElsewhereByHandIsMeasuredAtOnceByAll() {
        Simulation simulation = simulation(CORNER, 0, 1);
        SimulatedRobot robot = robot(simulation);
        simulation.run(41);
        robot.place(1, 0, 0);
        double[] atOnce = robot.sonarRangesMeters();
        assertEquals((1 - 0.166) / Math.cos(Math.toRadians(2.5)), atOnce[3], 1e-9);
        assertEquals(1 - 0.136, atOnce[0], 1e-9);
        SimulatedRobot other = simulation.addRobot("other", new Position(1, -1), 0);
        assertEquals(1 - 0.136 - 0.19, robot.sonarRangesMeters()[7], 1e-9);
        simulation.run(1);
        assertEquals(1 - 0.136 - 0.19, robot.sonarRangesMeters()[7], 1e-9);
        simulation.removeRobot(other);
        assertEquals(5, robot.sonarRangesMeters()[7]);
        simulation.change(World.bare());
        assertEquals(5, robot.sonarRangesMeters()[0]);
    }

    @Test
    void aRobotThatHasComeToRestMeasuresFromWhereItStands() {
        Simulation simulation = simulation(CORNER, 0, 1);
        SimulatedRobot robot = robot(simulation);
        robot.start(new Instruction.Forward(50), outcome -> {});
        while (robot.status() == RobotStatus.MOVING) {
            simulation.step();
        }
        assertEquals((1.5 - 0.166) / Math.cos(Math.toRadians(2.5)), robot.sonarRangesMeters()[3], 1e-9);
        assertEquals((1.5 - 0.166) / Math.cos(Math.toRadians(2.5)), robot.sonarRangesMeters()[4], 1e-9);
    }

    /** So a window, a client or a log may read at any time: the robot goes on in the same way. */
    @Test
    void readingSonarsAtAnyTimeChangesNothing() {
        List<double[]> heard = new ArrayList<>();
        for (int run = 0; run < 2; run++) {
            Simulation simulation = simulation(CORNER, 1, 4);
            SimulatedRobot robot = robot(simulation);
            SimulatedRobot other = simulation.addRobot("other", new Position(-1, -1), 1);
            robot.autonomy().begin(BehaviourKind.WANDER);
            other.autonomy().begin(BehaviourKind.WANDER);
            for (int step = 0; step < 3000; step++) {
                simulation.step();
                if (run == 1 && step % 3 == 0) {
                    robot.sonarRangesMeters();
                    other.sonarRangesMeters();
                }
            }
            heard.add(robot.sonarRangesMeters());
            heard.add(new double[] {robot.xMeters(), robot.yMeters(), other.xMeters(), other.yMeters()});
        }
        assertArrayEquals(heard.get(0), heard.get(2));
        assertArrayEquals(heard.get(1), heard.get(3));
    }
}
