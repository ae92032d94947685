package simrobot.ros;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import simgsm.web.AccessKeys;
import simrobot.simulation.SimulationThread;

/** The readings and controls for ROS programs; callable on any thread. */
public interface RosSource {
    /** The names of the robots; all are simulated. */
    List<String> robots();

    SimulationThread simulation();

    /** The keys of drivers; without keys every program of this machine may drive. */
    Optional<AccessKeys> keys();

    /**
     * Submits an order in keys of the telephone.
     *
     * @param ended receives the number of the reply tone and the reply, on the simulation's thread
     */
    void order(String robot, String operator, String keys, BiConsumer<Integer, String> ended);
}
