package simrobot.app.window;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import simrobot.control.LoggedEvent;
import simrobot.replay.RecordedEvent;
import simrobot.replay.Recording;
import simrobot.replay.ReplayThread;
import simrobot.robot.Placement;
import simrobot.simulation.SimulationSnapshot;
import simrobot.ui.Timeline;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.inspector.RefusalTexts;
import simrobot.world.World;
import vericommand.Pose;

/** A recorded session for the window: a view with a movable time that cannot be changed. */
public final class ReplayModel extends SessionModel {
    private final ReplayThread replay;
    private final RefusalTexts refusals;
    private final Timeline timeline;
    private final List<LoggedEvent> events = new ArrayList<>();
    private List<LoggedEvent> shown = List.of();

    public ReplayModel(ReplayThread replay, RefusalTexts refusals) {
        super(replay, robot -> RecordedTrack.csv(replay.recording().path(), robot), refusals);
        this.replay = replay;
        this.refusals = refusals;
        Recording recording = replay.recording();
        timeline = new Timeline(recording.firstNanos(), recording.lastNanos(), recording.markers());
        for (RecordedEvent event : recording.events()) {
            ReplayedEvents.of(event).ifPresent(events::add);
        }
    }

    private String damage() {
        return replay.recording().damage().map(refusals::damaged).orElse("");
    }

    @Override
    WindowSnapshot observe() {
        SimulationSnapshot scene = replay.snapshot();
        return new WindowSnapshot(
                scene,
                List.of(),
                replay.speed(),
                replay.isPaused(),
                replay.recording().path(),
                notice(damage()),
                List.of(),
                until(scene.timeNanos()),
                Optional.of(timeline),
                Optional.empty(),
                false);
    }

    /** The events up to that time; the same list while there are no more. */
    private List<LoggedEvent> until(long nanos) {
        int low = 0;
        int high = events.size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (events.get(middle).timeNanos() <= nanos) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        if (shown.size() != low) {
            shown = List.copyOf(events.subList(0, low));
        }
        return shown;
    }

    // ---- looking ---------------------------------------------------------------------------------------------------

    @Override
    public void seek(long nanos) {
        replay.seek(nanos);
    }

    @Override
    public void watch(String robot) {
        replay.watch(robot == null ? "" : robot);
    }

    // ---- actions that a recording refuses
    // ----------------------------------------------------------------------------

    @Override
    public void place(String robot, double xMeters, double yMeters, double headingRadians, Consumer<Placement> answer) {
        answer.accept(Placement.MOVING);
    }

    @Override
    public void addRobot(String name, String number, Optional<Pose> place, Consumer<Optional<String>> answer) {
        answer.accept(Optional.of(refusals.onlyLookedAt()));
    }

    @Override
    public void apply(World world, Path file, Consumer<Optional<String>> answer) {
        answer.accept(Optional.of(refusals.onlyLookedAt()));
    }

    @Override
    public void save(World world, Path file, Consumer<Optional<String>> answer) {
        answer.accept(Optional.of(refusals.onlyLookedAt()));
    }
}
