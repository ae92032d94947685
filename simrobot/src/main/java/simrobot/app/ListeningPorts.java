package simrobot.app;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.UsageException;
import simgsm.modem.at.port.AtPort;
import simgsm.net.FirstExchange;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.http.WebServer;
import simrobot.http.WebSource;
import simrobot.p2os.P2osServer;
import simrobot.simulation.SimulationSnapshot;

/** The ports on which the program listens, as the command line names them: AT commands, P2OS and HTTP. */
public final class ListeningPorts implements AutoCloseable {
    static final int MAX_PORT = 0xffff;

    private static final byte[] STATUS = "GET /robots HTTP/1.0\r\n\r\n".getBytes(StandardCharsets.US_ASCII);

    private final InetAddress address;
    private final AtPorts at;
    private final P2osPorts p2os;
    private final Optional<WebServer> web;

    private ListeningPorts(InetAddress address, AtPorts at, P2osPorts p2os, Optional<WebServer> web) {
        this.address = address;
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
                return new ListeningPorts(address, at, p2os, web(arguments, address, simRobot));
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

        @Override
        public String modem(String name) {
            return simRobot.robot(name)
                    .map(robot -> robot.modemState().state().word())
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

    /** Serves the ports; the simulation runs already. */
    public void start() {
        p2os.start();
        web.ifPresent(WebServer::start);
        p2os.first().ifPresent(port -> FirstExchange.with(address, port, P2osServer.FIRST_REQUESTS));
        at.first().ifPresent(AtPort::exchangeFirst);
        http().ifPresent(port -> FirstExchange.with(address, port, STATUS));
    }

    @Override
    public void close() {
        web.ifPresent(WebServer::close);
        p2os.close();
        at.close();
    }
}
