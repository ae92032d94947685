package simrobot.process;

import java.util.List;
import simrobot.world.Position;
import simrobot.world.World;

/** What a process may know of its robot's surroundings beyond the robot's senses; for the robot's owner thread. */
public interface Surroundings {
    /** The robot's index, from 0. */
    int robotNumber();

    World world();

    /** The places of the other robots. */
    List<Position> otherRobots();

    /** For a process that waits for its decisions. */
    WaitBudget waitBudget();
}
