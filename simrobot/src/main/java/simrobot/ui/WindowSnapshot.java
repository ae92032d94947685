package simrobot.ui;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import simrobot.control.LoggedEvent;
import simrobot.simulation.SimulationSnapshot;

/**
 * The state that the window shows; immutable.
 *
 * @param lines one for each robot that has a modem
 * @param speed simulated seconds per second; infinity for as fast as the machine can
 * @param worldFile the file of the current world
 * @param notice a message for the user, empty for none
 * @param ports on which the program listens
 * @param events the log, the oldest first
 * @param timeline of the recording that is played; empty in a running simulation
 * @param recording the file to which the session is being recorded
 * @param worldChanged whether the world's file has been changed on the disk since it was loaded
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
