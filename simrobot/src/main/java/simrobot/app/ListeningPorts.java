package simrobot.app;

import java.io.IOException;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.UsageException;
import simrobot.control.SimRobot;

/** All ports that the program listens on. */
public record ListeningPorts(P2osPorts pioneers, WebPort web) implements AutoCloseable {
    /** Opens what the command line asks for; before the simulation starts. */
    public static ListeningPorts open(Arguments arguments, SimRobot simRobot) throws UsageException, IOException {
        P2osPorts pioneers = P2osPorts.open(arguments, simRobot);
        try {
            return new ListeningPorts(pioneers, WebPort.open(arguments, simRobot));
        } catch (UsageException | IOException e) {
            pioneers.close();
            throw e;
        }
    }

    /** Adds the ports to what a program says at first. */
    public Event with(Event ready) {
        return web.with(pioneers.with(ready));
    }

    public void start() {
        pioneers.start();
        web.start();
    }

    @Override
    public void close() {
        web.close();
        pioneers.close();
    }
}
