package simrobot.app.ports;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.UsageException;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;

/** The ports of an option, one per robot upward from the option's value; none without the option. */
final class RobotPorts implements AutoCloseable {
    private static final Logger LOG = System.getLogger(RobotPorts.class.getName());

    /**
     * A robot's open port.
     *
     * @param exchange performs a first exchange with it
     */
    record RobotPort(int number, Runnable exchange, Runnable closing) {}

    /** Opens a robot's port; empty if the robot cannot have one. */
    interface Opener {
        Optional<RobotPort> open(TelephoneRobot robot, InetSocketAddress address) throws IOException;
    }

    private final String option;
    private final InetAddress address;
    private final Opener opener;
    private final Map<String, RobotPort> ports = Collections.synchronizedMap(new LinkedHashMap<>());
    /** The next robot's port; 0 for any free one. */
    private int next;

    RobotPorts(String option, InetAddress address, Opener opener) {
        this.option = option;
        this.address = address;
        this.opener = opener;
    }

    /** Opens a port for each robot, before the start, and for each later one. */
    void open(Arguments arguments, SimRobot simRobot) throws UsageException, IOException {
        next = (int) arguments.integer(option, 0, 0, ListeningPorts.MAX_PORT);
        if (!arguments.has(option)) {
            return;
        }
        int count = simRobot.robots().size();
        if (next + count - 1 > ListeningPorts.MAX_PORT) {
            throw new UsageException("--" + option + ": " + count + " ports upward from " + next + " end above "
                    + ListeningPorts.MAX_PORT);
        }
        for (TelephoneRobot robot : simRobot.robots()) {
            add(robot);
        }
        simRobot.onAdded(this::added);
        simRobot.onRemoved(
                robot -> Optional.ofNullable(ports.remove(robot.name())).ifPresent(port -> port.closing.run()));
    }

    private void add(TelephoneRobot robot) throws IOException {
        Optional<RobotPort> port = opener.open(robot, new InetSocketAddress(address, next));
        if (port.isPresent()) {
            ports.put(robot.name(), port.get());
            next += next > 0 ? 1 : 0;
        }
    }

    private void added(TelephoneRobot robot) {
        if (!ports.containsKey(robot.name())) {
            try {
                add(robot);
            } catch (IOException | IllegalArgumentException e) {
                LOG.log(Level.WARNING, robot.name() + " has no port by --" + option + ": " + e.getMessage());
            }
        }
    }

    /** Adds the ports to the program's first event. */
    Event with(Event ready) {
        return ports.isEmpty()
                ? ready
                : ready.with(
                        option,
                        ports.values().stream()
                                .map(port -> String.valueOf(port.number))
                                .collect(Collectors.joining(",")));
    }

    /** A robot's port, if it has one; callable on any thread. */
    Optional<Integer> of(String robot) {
        return Optional.ofNullable(ports.get(robot)).map(RobotPort::number);
    }

    /** Makes the first exchange with the first robot's port, if there is one. */
    void exchangeFirst() {
        ports.values().stream().findFirst().ifPresent(port -> port.exchange.run());
    }

    @Override
    public void close() {
        ports.values().forEach(port -> port.closing.run());
    }
}
