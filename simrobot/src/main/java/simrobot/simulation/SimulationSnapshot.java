package simrobot.simulation;

import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.function.BiPredicate;
import java.util.stream.IntStream;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.world.World;

/**
 * A simulation at one instant; immutable.
 *
 * @param timeNanos simulated time since the start
 * @param behaviours the available processes, NONE first
 * @param numberedBehaviours those of them that orders can start, by number
 * @param behaviourFaults faults in students' processes
 */
public record SimulationSnapshot(
        long timeNanos,
        World world,
        List<RobotSnapshot> robots,
        List<BehaviourKind> behaviours,
        SortedMap<Integer, BehaviourKind> numberedBehaviours,
        List<BehaviourList.Fault> behaviourFaults) {
    public SimulationSnapshot {
        robots = List.copyOf(robots);
        behaviours = List.copyOf(behaviours);
    }

    /** True if both snapshots have the same number of robots, and each pair of them is alike. */
    public boolean hasRobotsAs(SimulationSnapshot other, BiPredicate<RobotSnapshot, RobotSnapshot> areAlike) {
        return robots.size() == other.robots.size()
                && IntStream.range(0, robots.size()).allMatch(i -> areAlike.test(robots.get(i), other.robots.get(i)));
    }

    public Optional<RobotSnapshot> robot(String name) {
        return robots.stream().filter(robot -> robot.name().equals(name)).findFirst();
    }
}
