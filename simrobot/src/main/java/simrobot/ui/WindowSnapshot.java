package simrobot.ui;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import simrobot.control.LoggedEvent;
import simrobot.simulation.SimulationSnapshot;

/**
 * The state of the window; immutable.
 *
 * @param lines one for each robot that has a modem
 * @param speed simulated seconds per second; infinity for unlimited
 * @param worldFile the file of the current world
 * @param notice a message for the user; may be empty
 * @param ports of the program
 * @param events the log, oldest first
 * @param timeline of the played recording; empty in a running simulation
 * @param recording the file of the running recording
 * @param worldChanged true if the world's file has changed on the disk since it was loaded
 */
public record WindowSnapshot(
        SimulationSnapshot simulation,
        List<TelephoneSnapshot> lines,
        double speed,
        boolean paused,
        Path worldFile,
        String notice,
        List<OpenPort> ports,
        List<LoggedEvent> events,
        Optional<Timeline> timeline,
        Optional<Path> recording,
        boolean worldChanged) {
    public WindowSnapshot {
        lines = List.copyOf(lines);
        ports = List.copyOf(ports);
        events = List.copyOf(events);
    }
}
