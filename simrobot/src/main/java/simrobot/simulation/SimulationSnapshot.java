package simrobot.simulation;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.world.World;

/**
 * A simulation at one instant; immutable.
 *
 * @param timeNanos simulated time since the start
 * @param behaviours the processes that robots can run, NONE first
 * @param behaviourFaults what is wrong with processes of students
 */
public record SimulationSnapshot(
        long timeNanos,
        World world,
        List<RobotSnapshot> robots,
        List<BehaviourKind> behaviours,
        List<BehaviourList.Fault> behaviourFaults) {
    public SimulationSnapshot {
        Objects.requireNonNull(world);
        robots = List.copyOf(robots);
        behaviours = List.copyOf(behaviours);
    }

    public Optional<RobotSnapshot> robot(String name) {
        return robots.stream().filter(robot -> robot.name().equals(name)).findFirst();
    }
}
