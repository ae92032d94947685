package simrobot.app;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.FatalError;
import simgsm.console.UsageException;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.p2os.DiscoveryPort;
import simrobot.p2os.P2osServer;

/** The robots' P2OS ports, one per robot upward from {@code --p2os PORT}; none without the option. */
final class P2osPorts implements AutoCloseable {
    private static final Logger LOG = System.getLogger(P2osPorts.class.getName());

    private final Optional<P2osServer> server;
    private final Map<String, Integer> ports = Collections.synchronizedMap(new LinkedHashMap<>());

    private final ClientRequests requests;
    private final Optional<DiscoveryPort> discovery;

    private P2osPorts(Optional<P2osServer> server, Optional<DiscoveryPort> discovery, SimRobot simRobot) {
        this.server = server;
        this.discovery = discovery;
        requests = new ClientRequests(simRobot);
        server.ifPresent(serving -> serving.setRequests(requests));
    }

    /** Opens a port for each robot, before the simulation starts. */
    static P2osPorts open(Arguments arguments, InetAddress address, SimRobot simRobot)
            throws UsageException, IOException {
        if (!arguments.has("p2os")) {
            return new P2osPorts(Optional.empty(), Optional.empty(), simRobot);
        }
        int first = (int) arguments.integer("p2os", 0, 0, ListeningPorts.MAX_PORT);
        int last = first + simRobot.robots().size() - 1;
        if (last > ListeningPorts.MAX_PORT) {
            throw new UsageException("--p2os: " + simRobot.robots().size() + " ports upward from " + first
                    + " end above " + ListeningPorts.MAX_PORT);
        }
        P2osServer server = new P2osServer(simRobot.simulation(), address, first);
        P2osPorts opened = new P2osPorts(Optional.of(server), discovery(address), simRobot);
        try {
            for (TelephoneRobot robot : simRobot.robots()) {
                if (robot.simulated().isPresent()) {
                    opened.ports.put(robot.name(), server.add(robot.simulated().get()));
                }
            }
        } catch (IOException e) {
            opened.close();
            throw e;
        }
        simRobot.onAdded(opened::added);
        simRobot.onRemoved(opened::removed);
        return opened;
    }

    /** Empty if the port is in use: of several simulators on a machine the first answers. */
    private static Optional<DiscoveryPort> discovery(InetAddress address) {
        try {
            return Optional.of(DiscoveryPort.open(new InetSocketAddress(address, DiscoveryPort.USUAL_PORT)));
        } catch (IOException inUse) {
            LOG.log(Level.INFO, "no discovery on UDP port " + DiscoveryPort.USUAL_PORT + ": " + inUse.getMessage());
            return Optional.empty();
        }
    }

    /** Adds the ports to the program's first event. */
    Event with(Event ready) {
        return ports.isEmpty()
                ? ready
                : ready.with(
                        "p2os", ports.values().stream().map(String::valueOf).collect(Collectors.joining(",")));
    }

    /** Sets what loads a world that a client asks for, in place of the simulation alone. */
    void setWorldLoader(Consumer<Path> loader) {
        requests.setLoader(loader);
    }

    void start() {
        server.ifPresent(started -> started.start(cause -> FatalError.end("simrobot", cause)));
        discovery.ifPresent(DiscoveryPort::start);
    }

    /** Opens a port for a robot that is added later. */
    private void added(TelephoneRobot robot) {
        if (robot.simulated().isPresent() && !ports.containsKey(robot.name())) {
            try {
                ports.put(
                        robot.name(), server.orElseThrow().add(robot.simulated().get()));
            } catch (IOException e) {
                LOG.log(Level.WARNING, robot.name() + " has no P2OS port: " + e.getMessage());
            }
        }
    }

    private void removed(TelephoneRobot robot) {
        if (ports.remove(robot.name()) != null) {
            server.orElseThrow().remove(robot.simulated().orElseThrow());
        }
    }

    /** A robot's port, if it has one; any thread may ask. */
    Optional<Integer> of(String robot) {
        return Optional.ofNullable(ports.get(robot));
    }

    /** The first robot's port, if there is one. */
    Optional<Integer> first() {
        return ports.values().stream().findFirst();
    }

    @Override
    public void close() {
        server.ifPresent(P2osServer::close);
        discovery.ifPresent(P2osPorts::close);
    }

    private static void close(DiscoveryPort port) {
        try {
            port.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing the discovery port failed", e);
        }
    }
}
