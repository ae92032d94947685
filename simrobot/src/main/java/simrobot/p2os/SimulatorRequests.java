package simrobot.p2os;

/** Requests of a client to the simulator, not to its robot; called on the simulation's thread. */
public interface SimulatorRequests {
    /** SIM_CTRL 1 and 2: loads a world for all robots. @param file as the client names it */
    default void loadWorld(String robot, String file) {}

    /** SIM_MESSAGE: shows a text to the operator. */
    default void show(String robot, String text) {}
}
