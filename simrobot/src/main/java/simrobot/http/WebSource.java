package simrobot.http;

import simrobot.simulation.SimulationSnapshot;

/** The state that the web server serves; called by any thread. */
public interface WebSource {
    /**
     * The current state of the simulation; called at most 20 times a second.
     *
     * @throws IllegalStateException with the reason if the simulation does not answer
     */
    SimulationSnapshot scene() throws InterruptedException;

    /** The telephone number of the robot's modem; empty if it has none. */
    String number(String robot);

    /** The state of the robot's modem, as {@link simgsm.modem.ModemState#word}; empty if it has none. */
    String modem(String robot);
}
