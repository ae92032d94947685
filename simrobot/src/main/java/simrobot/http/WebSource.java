package simrobot.http;

import simrobot.simulation.SimulationSnapshot;

/** Where the web server has its knowledge from; any thread asks. */
public interface WebSource {
    /**
     * The simulation as it is now; asked seldom, answered after at most some seconds.
     *
     * @throws IllegalStateException saying why, when the simulation does not answer
     */
    SimulationSnapshot scene() throws InterruptedException;

    /** The number under which this robot's modem can be called; empty when it has none. */
    String number(String robot);
}
