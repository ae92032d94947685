package simrobot.app;

import java.io.IOException;
import java.net.InetAddress;
import java.util.Optional;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.UsageException;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.http.WebServer;
import simrobot.http.WebSource;
import simrobot.simulation.SimulationSnapshot;

/** The ports on which the program listens, as the command line names them: AT commands, P2OS and HTTP. */
public final class ListeningPorts implements AutoCloseable {
    static final int MAX_PORT = 0xffff;

    private final AtPorts at;
    private final P2osPorts p2os;
    private final Optional<WebServer> web;

    private ListeningPorts(AtPorts at, P2osPorts p2os, Optional<WebServer> web) {
        this.at = at;
        this.p2os = p2os;
        this.web = web;
    }

    /** Opens the ports, before the simulation starts. They are served from {@link #start} on. */
    public static ListeningPorts open(Arguments arguments, SimRobot simRobot) throws UsageException, IOException {
        InetAddress address = arguments.bindAddress();
        AtPorts at = AtPorts.open(arguments, address, simRobot);
        try {
            P2osPorts p2os = P2osPorts.open(arguments, address, simRobot);
            try {
                return new ListeningPorts(at, p2os, web(arguments, address, simRobot));
            } catch (UsageException | IOException e) {
                p2os.close();
                throw e;
            }
        } catch (UsageException | IOException e) {
            at.close();
            throw e;
        }
    }

    private static Optional<WebServer> web(Arguments arguments, InetAddress address, SimRobot simRobot)
            throws UsageException, IOException {
        if (!arguments.has("http")) {
            return Optional.empty();
        }
        int port = (int) arguments.integer("http", 0, 0, MAX_PORT);
        return Optional.of(new WebServer(address, port, arguments.language(), new Source(simRobot)));
    }

    private record Source(SimRobot simRobot) implements WebSource {
        @Override
        public SimulationSnapshot scene() throws InterruptedException {
            return simRobot.onSimulation(simRobot::sceneWithLasers);
        }

        @Override
        public String number(String name) {
            return simRobot.robot(name)
                    .map(TelephoneRobot::number)
                    .map(number -> number.digits())
                    .orElse("");
        }
    }

    /** The robots' P2OS ports. */
    P2osPorts p2os() {
        return p2os;
    }

    /** The HTTP port, if there is one. */
    Optional<Integer> http() {
        return web.map(WebServer::port);
    }

    /** Adds the ports to the program's first event. */
    public Event with(Event ready) {
        Event both = p2os.with(at.with(ready));
        return http().map(port -> both.with("http", port)).orElse(both);
    }

    public void start() {
        p2os.start();
        web.ifPresent(WebServer::start);
    }

    @Override
    public void close() {
        web.ifPresent(WebServer::close);
        p2os.close();
        at.close();
    }
}
