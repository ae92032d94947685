package simrobot.process;

import java.util.List;
import simrobot.world.Position;
import simrobot.world.World;

/** A robot's surroundings beyond its senses, for its process; for the robot's owner thread. */
public interface Surroundings {
    /** The robot's index, from 0. */
    int robotNumber();

    World world();

    /** The positions of the other robots. */
    List<Position> otherRobots();

    /** Limits the wait for decisions. */
    WaitBudget waitBudget();
}
