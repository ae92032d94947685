package simrobot.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import simgsm.console.Event;
import simrobot.control.RobotEvent;
import simrobot.replay.SessionRecorder;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationThread;

/** Records the session; started and stopped by {@code --record} or from the window. */
public final class SessionRecording implements AutoCloseable {
    /** A file whose writing failed. */
    public record Failure(Path file, IOException why) {}

    private final SimulationThread simulation;
    private volatile SessionRecorder recorder;
    private volatile Path file;

    /** Creates an idle instance. */
    public SessionRecording(SimulationThread simulation) {
        this.simulation = simulation;
    }

    /** Starts a recording; on the simulation's thread, or before that runs. */
    public void start(Path path, Simulation owned) throws IOException {
        recorder = SessionRecorder.open(path, owned, simulation);
        file = path;
    }

    /**
     * Stops the recording, and starts another one if a file is named.
     *
     * @param problem receives the failure, on any thread
     */
    public void restart(Optional<Path> path, BiConsumer<Path, IOException> problem) {
        simulation.withSimulation(owned -> {
            close();
            if (path.isPresent()) {
                try {
                    start(path.get(), owned);
                } catch (IOException e) {
                    problem.accept(path.get(), e);
                }
            }
        });
    }

    /** The file being written; empty after a failure. */
    public Optional<Path> file() {
        return failure().isPresent() ? Optional.empty() : Optional.ofNullable(file);
    }

    /** The failure, such as a full disk, until the next stop or start. */
    public Optional<Failure> failure() {
        SessionRecorder current = recorder;
        Path path = file;
        return current == null || path == null
                ? Optional.empty()
                : current.failure().map(why -> new Failure(path, why));
    }

    /** Records an event, if a recording runs; callable on any thread. */
    public void event(Event event) {
        SessionRecorder current = recorder;
        if (current != null) {
            current.event(event);
        }
    }

    /** A listener that records the events of a robot. */
    public Consumer<RobotEvent> listener(String robot) {
        return event -> event(event.line(robot));
    }

    /** Stops the recording; on the simulation's thread, or after its end. */
    @Override
    public void close() {
        SessionRecorder current = recorder;
        recorder = null;
        file = null;
        if (current != null) {
            current.close();
        }
    }
}
