package simrobot.pioneer;

import java.util.List;
import simrobot.process.Surroundings;
import simrobot.process.WaitBudget;
import simrobot.world.Position;
import simrobot.world.World;

/** A floor without other robots. */
record MapOnly(World world) implements Surroundings {
    @Override
    public int robotNumber() {
        return 0;
    }

    @Override
    public List<Position> otherRobots() {
        return List.of();
    }

    @Override
    public WaitBudget waitBudget() {
        return new WaitBudget();
    }
}
