package simrobot.app;

import java.io.IOException;
import java.net.InetAddress;
import java.util.Optional;
import java.util.OptionalInt;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.UsageException;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.http.WebServer;
import simrobot.http.WebSource;
import simrobot.simulation.SimulationSnapshot;

/** The robots' web server, if the command line asks for it. */
final class WebPort implements AutoCloseable {
    private static final int MAX_PORT = 0xffff;

    private final Optional<WebServer> server;

    private WebPort(Optional<WebServer> server) {
        this.server = server;
    }

    /** Opens the port; answers come from the start on. */
    static WebPort open(Arguments arguments, SimRobot simRobot) throws UsageException, IOException {
        InetAddress address = ListeningAddress.of(arguments);
        if (!arguments.has("http")) {
            return new WebPort(Optional.empty());
        }
        int port = (int) arguments.integer("http", 0, 0, MAX_PORT);
        return new WebPort(Optional.of(new WebServer(address, port, arguments.language(), new Source(simRobot))));
    }

    private record Source(SimRobot simRobot) implements WebSource {
        @Override
        public SimulationSnapshot scene() throws InterruptedException {
            return simRobot.onSimulation(simRobot::scene);
        }

        @Override
        public String number(String name) {
            return simRobot.robots().stream()
                    .filter(robot -> robot.name().equals(name))
                    .findFirst()
                    .map(TelephoneRobot::number)
                    .map(number -> number.digits())
                    .orElse("");
        }
    }

    /** Adds the port to what a program says at first. */
    Event with(Event ready) {
        return server.map(open -> ready.with("http", open.port())).orElse(ready);
    }

    /** Empty without a server. */
    OptionalInt port() {
        return server.isPresent() ? OptionalInt.of(server.get().port()) : OptionalInt.empty();
    }

    void start() {
        server.ifPresent(WebServer::start);
    }

    @Override
    public void close() {
        server.ifPresent(WebServer::close);
    }
}
