package simrobot.ui;

import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import simrobot.control.LoggedEvent;
import simrobot.simulation.SimulationSnapshot;

/**
 * All that the window shows, immutable.
 *
 * @param lines one for each robot that has a modem
 * @param speed simulated seconds per second; infinite is as fast as it can
 * @param worldFile the file of the present world
 * @param notice a message for the person at the window, empty when there is none
 * @param ports on which others may come
 * @param events what happened, the oldest first
 * @param timeline when this is a recording that is played; then nothing can be done to its robots
 * @param recording the file in which the session is being recorded
 * @param worldChanged whether the world's file has been changed on the disk since
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
        Objects.requireNonNull(simulation);
        lines = List.copyOf(lines);
        Objects.requireNonNull(worldFile);
        Objects.requireNonNull(notice);
        ports = List.copyOf(ports);
        events = List.copyOf(events);
        Objects.requireNonNull(timeline);
        Objects.requireNonNull(recording);
    }
}
