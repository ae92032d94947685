package simrobot.app;

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
import simgsm.modem.at.AtProfile;
import simgsm.modem.at.port.AtPort;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;

/** The ports for AT commands to the robots' modems, one per robot upward from {@code --at PORT}. */
final class AtPorts implements AutoCloseable {
    private static final Logger LOG = System.getLogger(AtPorts.class.getName());

    private final SimRobot simRobot;
    private final InetAddress address;
    private final AtProfile profile;
    /** The next robot's port; 0 for any free one. */
    private int next;

    private final Map<String, AtPort> ports = Collections.synchronizedMap(new LinkedHashMap<>());

    private AtPorts(SimRobot simRobot, InetAddress address, AtProfile profile, int first) {
        this.simRobot = simRobot;
        this.address = address;
        this.profile = profile;
        next = first;
    }

    /** Opens a port for each robot with M2, before the start; none without the option. */
    static AtPorts open(Arguments arguments, InetAddress address, SimRobot simRobot)
            throws UsageException, IOException {
        int first = (int) arguments.integer("at", 0, 0, ListeningPorts.MAX_PORT);
        AtProfile profile = arguments.value("at-profile", AtProfile::named).orElse(AtProfile.PLAIN);
        AtPorts opened = new AtPorts(simRobot, address, profile, first);
        if (!arguments.has("at")) {
            return opened;
        }
        int last = first + simRobot.robots().size() - 1;
        if (last > ListeningPorts.MAX_PORT) {
            throw new UsageException("--at: " + simRobot.robots().size() + " ports upward from " + first + " end above "
                    + ListeningPorts.MAX_PORT);
        }
        try {
            for (TelephoneRobot robot : simRobot.robots()) {
                opened.add(robot);
            }
        } catch (IOException e) {
            opened.close();
            throw e;
        }
        simRobot.onAdded(opened::added);
        simRobot.onRemoved(opened::removed);
        return opened;
    }

    private void add(TelephoneRobot robot) throws IOException {
        Optional<AtPort> port = simRobot.openAtPort(robot, new InetSocketAddress(address, next), profile);
        if (port.isPresent()) {
            ports.put(robot.name(), port.get());
            next += next > 0 ? 1 : 0;
        }
    }

    /** Opens a port for a robot that is added later. */
    private void added(TelephoneRobot robot) {
        if (!ports.containsKey(robot.name())) {
            try {
                add(robot);
            } catch (IOException | IllegalArgumentException e) {
                LOG.log(Level.WARNING, robot.name() + " has no port for AT commands: " + e.getMessage());
            }
        }
    }

    private void removed(TelephoneRobot robot) {
        AtPort port = ports.remove(robot.name());
        if (port != null) {
            port.close();
        }
    }

    /** Adds the ports to the program's first event. */
    Event with(Event ready) {
        return ports.isEmpty()
                ? ready
                : ready.with(
                        "at",
                        ports.values().stream()
                                .map(port -> String.valueOf(port.port()))
                                .collect(Collectors.joining(",")));
    }

    /** The first robot's port, if there is one. */
    Optional<AtPort> first() {
        return ports.values().stream().findFirst();
    }

    @Override
    public void close() {
        ports.values().forEach(AtPort::close);
    }
}
