package simrobot.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.UsageException;
import simrobot.control.SimRobot;
import simrobot.replay.SessionRecorder;
import simrobot.simulation.Simulation;

/** The session's recording, if the command line asks for one. To be closed when the simulation has ended. */
public final class SessionRecord implements AutoCloseable {
    private final Optional<SessionRecorder> recorder;

    private SessionRecord(Optional<SessionRecorder> recorder) {
        this.recorder = recorder;
    }

    /** Begins it, before the simulation starts. */
    public static SessionRecord open(Arguments arguments, Simulation simulation, SimRobot simRobot)
            throws UsageException, IOException {
        Optional<Path> file = arguments.path("record");
        return new SessionRecord(
                file.isPresent()
                        ? Optional.of(SessionRecorder.open(file.get(), simulation, simRobot.simulation()))
                        : Optional.empty());
    }

    /** A console's events go into the recording, too. */
    public Consumer<Event> with(Consumer<Event> console) {
        return recorder.map(file -> console.andThen(file::event)).orElse(console);
    }

    /** Where there is no console: what it would be told. */
    public void listenTo(SimRobot simRobot) {
        recorder.ifPresent(file ->
                simRobot.onAdded(robot -> robot.listen(event -> file.event(event.line(robot.name())))));
    }

    @Override
    public void close() {
        recorder.ifPresent(SessionRecorder::close);
    }
}
