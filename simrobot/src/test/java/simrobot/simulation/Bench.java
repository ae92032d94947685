package simrobot.simulation;

import java.util.ArrayList;
import java.util.List;
import simrobot.robot.SimulatedRobot;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;

/** A simulation with one robot, moved by hand, that records the reported events. */
final class Bench {
    final Simulation simulation;
    final SimulatedRobot robot;
    final List<RobotStatus> statuses = new ArrayList<>();
    final List<MotionOutcome> outcomes = new ArrayList<>();

    Bench(World world, double x, double y, double headingDegrees) {
        simulation = new Simulation(world, 1);
        robot = simulation.addRobot("robot", new Position(x, y), Math.toRadians(headingDegrees));
        robot.addStatusListener(statuses::add);
    }

    static Bench withWalls(Segment... walls) {
        return new Bench(World.of("walls", List.of(walls)), 0, 0, 0);
    }

    static Bench onBareFloor() {
        return new Bench(World.bare(), 0, 0, 0);
    }

    Bench forward(int centimeters) {
        robot.start(new Instruction.Forward(centimeters), outcomes::add);
        return this;
    }

    Bench turn(int clockwiseDegrees) {
        robot.start(new Instruction.Turn(clockwiseDegrees), outcomes::add);
        return this;
    }

    /** Steps until the motion has ended; returns how it did. */
    MotionOutcome untilEnded() {
        int known = outcomes.size();
        for (int i = 0; outcomes.size() == known && i < 10_000_000; i++) {
            simulation.step();
        }
        return outcomes.get(known);
    }

    Bench seconds(double seconds) {
        simulation.run((int) Math.round(seconds * 100));
        return this;
    }
}
