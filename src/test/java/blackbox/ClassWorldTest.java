package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.classroom.demo.ClassWorld;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.MapReader;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome;

/** The world of {@code --demo --class N}. */
class ClassWorldTest {
    private static final int MOST_STEPS = 3_000;

    private static Simulation simulation(int students) throws Exception {
        Simulation simulation = new Simulation(MapReader.read("class.map", new ClassWorld(students).map()), 1);
        simulation.addRobots(
                IntStream.range(0, students).mapToObj(i -> "robot" + (i + 1)).toList());
        return simulation;
    }

    private static List<MotionOutcome> drive(Simulation simulation, int centimeters) {
        return drive(simulation, new Instruction.Forward(centimeters));
    }

    private static List<MotionOutcome> drive(Simulation simulation, Instruction.Motion motion) {
        List<MotionOutcome> outcomes = new ArrayList<>();
        for (SimulatedRobot robot : simulation.robots()) {
            robot.setPower(true);
            robot.setMotors(true);
            robot.start(motion, outcomes::add);
        }
        for (int i = 0; i < MOST_STEPS && outcomes.size() < simulation.robots().size(); i++) {
            simulation.step();
        }
        return outcomes;
    }

    private static IntStream classes() {
        return IntStream.rangeClosed(2, 40);
    }

    @ParameterizedTest
    @MethodSource("classes")
    void eachRobotStartsAtItsHomeAndAllHaveTheSameWayToTheirGoals(int students) throws Exception {
        Simulation simulation = simulation(students);
        World world = simulation.world();
        ClassWorld lanes = new ClassWorld(students);
        List<Home> homes = world.items(Home.class);
        List<Goal> goals = world.items(Goal.class);
        assertEquals(students, homes.size());
        assertEquals(students, goals.size());
        Set<String> places = new HashSet<>();
        for (int i = 0; i < students; i++) {
            SimulatedRobot robot = simulation.robots().get(i);
            assertEquals(homes.get(i).name(), robot.name());
            assertEquals(homes.get(i).position().xMeters(), robot.xMeters());
            assertEquals(homes.get(i).position().yMeters(), robot.yMeters());
            assertEquals(lanes.goalXMeters(i), goals.get(i).position().xMeters());
            assertEquals(lanes.goalYMeters(i), goals.get(i).position().yMeters());
            assertEquals(4.0, lanes.goalXMeters(i) - robot.xMeters(), 1e-9);
            assertEquals(0.4, lanes.goalYMeters(i) - robot.yMeters(), 1e-9);
            assertTrue(places.add(robot.xMeters() + " " + robot.yMeters()));
        }
    }

    @ParameterizedTest
    @MethodSource("classes")
    void allRobotsOfAClassDriveTwoMetersAtOnce(int students) throws Exception {
        List<MotionOutcome> outcomes = drive(simulation(students), 200);
        assertEquals(students, outcomes.size());
        outcomes.forEach(outcome -> assertEquals(MotionOutcome.Ending.DONE, outcome.ending()));
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 20, 40})
    void aRobotThatDrivesStraightToTheGoalMeetsTheBox(int students) throws Exception {
        List<MotionOutcome> outcomes = drive(simulation(students), 380);
        assertEquals(students, outcomes.size());
        outcomes.forEach(outcome -> {
            assertEquals(MotionOutcome.Ending.COLLISION, outcome.ending());
            assertEquals(245, outcome.amountDone(), 0.1);
        });
    }

    @Test
    void aWayRoundTheBoxLeadsToTheGoal() throws Exception {
        Simulation simulation = simulation(3);
        for (Instruction.Motion motion : List.of(
                new Instruction.Forward(100),
                new Instruction.Turn(315),
                new Instruction.Forward(127),
                new Instruction.Turn(45),
                new Instruction.Forward(160),
                new Instruction.Turn(45),
                new Instruction.Forward(70))) {
            drive(simulation, motion)
                    .forEach(outcome -> assertEquals(MotionOutcome.Ending.DONE, outcome.ending(), motion.toString()));
        }
        ClassWorld lanes = new ClassWorld(3);
        for (int i = 0; i < 3; i++) {
            SimulatedRobot robot = simulation.robots().get(i);
            double left = Math.hypot(robot.xMeters() - lanes.goalXMeters(i), robot.yMeters() - lanes.goalYMeters(i));
            assertTrue(left < 0.1, "metres to the goal: " + left);
        }
    }
}
