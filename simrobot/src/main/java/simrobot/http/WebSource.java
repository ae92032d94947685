package simrobot.http;

import java.util.function.Consumer;
import simrobot.simulation.SimulationSnapshot;
import vericommand.OrderReport;

/** The robots behind the web server; called by any thread. */
public interface WebSource {
    /**
     * The current state of the simulation; called at most 20 times a second.
     *
     * @throws IllegalStateException with the reason if the simulation does not answer
     */
    SimulationSnapshot scene() throws InterruptedException;

    /** The telephone number of the robot's modem; empty if it has none. */
    String number(String robot);

    /**
     * Submits an order of a program; see {@link simrobot.control.TelephoneRobot#order}.
     *
     * @return false if there is no such robot
     * @throws IllegalStateException with the reason if the simulation does not answer
     */
    boolean order(String robot, String operator, String keys, Consumer<OrderReport> follower)
            throws InterruptedException;

    /** The state of the robot's modem, as {@link simgsm.modem.ModemState#word}; empty if it has none. */
    String modem(String robot);
}
