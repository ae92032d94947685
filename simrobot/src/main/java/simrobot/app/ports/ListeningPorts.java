package simrobot.app.ports;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.FatalError;
import simgsm.console.UsageException;
import simgsm.modem.at.AtProfile;
import simgsm.modem.at.port.AtPort;
import simgsm.net.FirstExchange;
import simgsm.web.AccessKeys;
import simrobot.app.ports.RobotPorts.RobotPort;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.http.WebServer;
import simrobot.http.WebSource;
import simrobot.p2os.DiscoveryPort;
import simrobot.p2os.P2osServer;
import simrobot.robot.SimulatedRobot;
import simrobot.ros.RosServer;
import simrobot.simulation.SimulationSnapshot;
import vericommand.OrderReport;

/** The program's listening ports that the command line names: AT commands, P2OS, HTTP and rosbridge. */
public final class ListeningPorts implements AutoCloseable {
    static final int MAX_PORT = 0xffff;

    private static final String KEYS = "http-keys";

    private static final Logger LOG = System.getLogger(ListeningPorts.class.getName());
    private static final byte[] STATUS = "GET /robots HTTP/1.0\r\n\r\n".getBytes(StandardCharsets.US_ASCII);

    private final InetAddress address;
    private final Map<String, AtPort> atPorts = new ConcurrentHashMap<>();
    private final RobotPorts at;
    /** Closed with the ports of the commands. */
    private final RobotPorts atAudio;

    private final RobotPorts p2os;
    private final ClientRequests requests;
    private Optional<P2osServer> server = Optional.empty();
    private Optional<DiscoveryPort> discovery = Optional.empty();
    private Optional<WebServer> web = Optional.empty();
    private Optional<RosServer> ros = Optional.empty();

    private ListeningPorts(Arguments arguments, SimRobot simRobot) throws UsageException {
        address = arguments.bindAddress();
        AtProfile profile = arguments.value("at-profile", AtProfile::named).orElse(AtProfile.PLAIN);
        at = new RobotPorts("at", address, (robot, place) -> {
            Optional<AtPort> opened = simRobot.openAtPort(robot, place, profile);
            opened.ifPresent(port -> atPorts.put(robot.name(), port));
            return opened.map(port -> new RobotPort(port.port(), port::exchangeFirst, port::close));
        });
        atAudio = new RobotPorts("at-audio", address, (robot, place) -> {
            int port = atPorts.get(robot.name()).openAudio(place);
            return Optional.of(new RobotPort(port, () -> {}, () -> {}));
        });
        p2os = new RobotPorts("p2os", address, this::openP2os);
        requests = new ClientRequests(simRobot);
        if (arguments.has("p2os")) {
            server = Optional.of(new P2osServer(simRobot.simulation(), address, requests));
        }
    }

    private Optional<RobotPort> openP2os(TelephoneRobot telephone, InetSocketAddress place) throws IOException {
        if (telephone.simulated().isEmpty()) {
            return Optional.empty();
        }
        SimulatedRobot robot = telephone.simulated().get();
        P2osServer serving = server.orElseThrow();
        int port = serving.add(robot, place.getPort());
        return Optional.of(new RobotPort(
                port, () -> FirstExchange.with(address, port, P2osServer.FIRST_REQUESTS), () -> serving.remove(robot)));
    }

    /** Opens the ports before the simulation starts; {@link #start} serves them. */
    public static ListeningPorts open(Arguments arguments, SimRobot simRobot) throws UsageException, IOException {
        ListeningPorts opened = new ListeningPorts(arguments, simRobot);
        try {
            opened.at.open(arguments, simRobot);
            if (arguments.has("at-audio") && !arguments.has("at")) {
                throw new UsageException("--at-audio: expected with --at PORT");
            }
            opened.atAudio.open(arguments, simRobot);
            opened.p2os.open(arguments, simRobot);
            if (arguments.has("p2os")) {
                opened.discovery = discovery(opened.address);
                warnIfReachable(opened.address);
            }
            Optional<AccessKeys> keys = keys(arguments);
            if (arguments.has("http")) {
                int port = (int) arguments.integer("http", 0, 0, MAX_PORT);
                opened.web = Optional.of(
                        new WebServer(opened.address, port, arguments.language(), new Source(simRobot), keys));
            }
            if (arguments.has("ros")) {
                int port = (int) arguments.integer("ros", 0, 0, MAX_PORT);
                opened.ros = Optional.of(
                        new RosServer(new InetSocketAddress(opened.address, port), new RosRobots(simRobot, keys)));
            }
            return opened;
        } catch (UsageException | IOException e) {
            opened.close();
            throw e;
        }
    }

    /** P2OS itself has no password, so real clients on other machines have none either. */
    private static void warnIfReachable(InetAddress address) {
        if (!address.isLoopbackAddress()) {
            LOG.log(Level.WARNING, "every machine that reaches the P2OS ports may move the robots");
        }
    }

    private static Optional<AccessKeys> keys(Arguments arguments) throws UsageException, IOException {
        Optional<Path> file = arguments.path(KEYS);
        if (file.isPresent() && !arguments.has("http") && !arguments.has("ros")) {
            throw new UsageException("--" + KEYS + ": expected with --http PORT or --ros PORT");
        }
        return file.isPresent() ? Optional.of(AccessKeys.read(file.get())) : Optional.empty();
    }

    /** Empty if the port is in use: with several simulators on a machine the first answers. */
    private static Optional<DiscoveryPort> discovery(InetAddress address) {
        try {
            return Optional.of(DiscoveryPort.open(new InetSocketAddress(address, DiscoveryPort.USUAL_PORT)));
        } catch (IOException inUse) {
            LOG.log(Level.INFO, "no discovery on UDP port " + DiscoveryPort.USUAL_PORT + ": " + inUse.getMessage());
            return Optional.empty();
        }
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
        public boolean order(String name, String operator, String keys, Consumer<OrderReport> follower)
                throws InterruptedException {
            return simRobot.onSimulation(() -> {
                Optional<TelephoneRobot> robot = simRobot.robot(name);
                robot.ifPresent(found -> found.order(operator, keys, follower));
                return robot.isPresent();
            });
        }

        @Override
        public String modem(String name) {
            return simRobot.robot(name)
                    .map(robot -> robot.modemState().state().word())
                    .orElse("");
        }
    }

    /** Sets the loader of worlds that a P2OS client requests; without one only the simulation loads them. */
    public void setWorldLoader(Consumer<Path> loader) {
        requests.setLoader(loader);
    }

    /** A robot's P2OS port, if it has one; callable on any thread. */
    public Optional<Integer> p2os(String robot) {
        return p2os.of(robot);
    }

    /** The HTTP port, if there is one. */
    public Optional<Integer> http() {
        return web.map(WebServer::port);
    }

    /** Adds the ports to the program's first event. */
    public Event with(Event ready) {
        Event both = p2os.with(atAudio.with(at.with(ready)));
        Event web = http().map(port -> both.with("http", port)).orElse(both);
        return ros.map(serving -> web.with("ros", serving.port())).orElse(web);
    }

    /** Serves the ports; called after the simulation's start. */
    public void start() {
        server.ifPresent(serving -> serving.start(cause -> FatalError.end("simrobot", cause)));
        discovery.ifPresent(DiscoveryPort::start);
        web.ifPresent(WebServer::start);
        ros.ifPresent(serving -> serving.start(cause -> FatalError.end("simrobot", cause)));
        p2os.exchangeFirst();
        at.exchangeFirst();
        http().ifPresent(port -> FirstExchange.with(address, port, STATUS));
    }

    @Override
    public void close() {
        web.ifPresent(WebServer::close);
        ros.ifPresent(RosServer::close);
        server.ifPresent(P2osServer::close);
        discovery.ifPresent(DiscoveryPort::close);
        at.close();
    }
}
