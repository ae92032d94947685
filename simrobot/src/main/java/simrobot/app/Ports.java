package simrobot.app;

import java.io.IOException;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.UsageException;
import simrobot.control.SimRobot;

/** All ports that the program listens on. */
public record Ports(PioneerPorts pioneers, WebPort web) implements AutoCloseable {
    /** Opens what the command line asks for; before the simulation starts. */
    public static Ports open(Arguments arguments, SimRobot simRobot) throws UsageException, IOException {
        PioneerPorts pioneers = PioneerPorts.open(arguments, simRobot);
        try {
            return new Ports(pioneers, WebPort.open(arguments, simRobot));
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
