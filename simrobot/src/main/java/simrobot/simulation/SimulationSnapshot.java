package simrobot.simulation;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import simrobot.world.World;

/**
 * A simulation at one instant; immutable.
 *
 * @param timeNanos simulated time since the start
 */
public record SimulationSnapshot(long timeNanos, World world, List<RobotSnapshot> robots) {
    public SimulationSnapshot {
        Objects.requireNonNull(world);
        robots = List.copyOf(robots);
    }

    public Optional<RobotSnapshot> robot(String name) {
        return robots.stream().filter(robot -> robot.name().equals(name)).findFirst();
    }
}
