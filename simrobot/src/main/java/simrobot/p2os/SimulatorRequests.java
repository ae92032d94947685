package simrobot.p2os;

/** Requests of a client to the simulator, not to its robot; called on the simulation's thread. */
public interface SimulatorRequests {
    /** Requests without effect. */
    SimulatorRequests IGNORED = new SimulatorRequests() {
        @Override
        public void loadWorld(String robot, String file) {}

        @Override
        public void show(String robot, String text) {}
    };

    /** SIM_CTRL 1 and 2: loads a world for all robots. @param file as the client names it */
    void loadWorld(String robot, String file);

    /** SIM_MESSAGE: shows a text to the operator. */
    void show(String robot, String text);
}
