package simrobot.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import simrobot.control.RobotEvent;
import simrobot.replay.SessionRecorder;
import simrobot.simulation.SimulationThread;

/** Records the session while somebody at the window wishes so. */
final class SessionButton {
    private final SimulationThread simulation;
    private final BiConsumer<Path, IOException> problem;
    private volatile SessionRecorder recorder;
    private volatile Path file;

    /** @param problem told why nothing is recorded; any thread tells */
    SessionButton(SimulationThread simulation, BiConsumer<Path, IOException> problem) {
        this.simulation = simulation;
        this.problem = problem;
    }

    /** In which the session is being recorded. */
    Optional<Path> file() {
        return Optional.ofNullable(file);
    }

    /** Records a robot's events while a recording runs. */
    Consumer<RobotEvent> of(String robot) {
        return event -> {
            SessionRecorder current = recorder;
            if (current != null) {
                current.event(event.line(robot));
            }
        };
    }

    /** Ends what was begun, and begins anew if a file is named. */
    void record(Optional<Path> wanted) {
        simulation.withSimulation(owned -> {
            close();
            if (wanted.isPresent()) {
                try {
                    recorder = SessionRecorder.open(wanted.get(), owned, simulation);
                    file = wanted.get();
                } catch (IOException e) {
                    problem.accept(wanted.get(), e);
                }
            }
        });
    }

    /** On the simulation's thread, or when that has ended. */
    void close() {
        SessionRecorder present = recorder;
        recorder = null;
        file = null;
        if (present != null) {
            present.close();
        }
    }
}
