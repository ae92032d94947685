package simrobot.robot;

import java.util.List;
import simrobot.process.Surroundings;
import simrobot.process.WaitBudget;
import simrobot.world.Position;
import simrobot.world.World;

/** What a process of a simulated robot may know of the floor. */
record FloorSurroundings(SimulatedRobot robot, Floor floor) implements Surroundings {
    @Override
    public int robotNumber() {
        return robot.number();
    }

    @Override
    public World world() {
        return floor.world();
    }

    @Override
    public List<Position> otherRobots() {
        return floor.others(robot);
    }

    @Override
    public WaitBudget waitBudget() {
        return floor.waitBudget();
    }
}
