package simrobot.app;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simrobot.control.FileExports;
import simrobot.control.LoggedEvent;
import simrobot.replay.RecordedEvent;
import simrobot.replay.Recording;
import simrobot.replay.ReplayThread;
import simrobot.robot.Placement;
import simrobot.simulation.SimulationSnapshot;
import simrobot.ui.OperatorActions;
import simrobot.ui.Timeline;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.floor.WorldPictures;
import simrobot.ui.inspector.RefusalTexts;
import simrobot.world.World;
import vericommand.Pose;

/** A recorded session as the window shows it: a view that can be moved in time, but not changed. */
public final class ReplayModel implements OperatorActions {
    private static final long NOTICE_NANOS = TimeUnit.SECONDS.toNanos(12);

    private final ReplayThread replay;
    private final RefusalTexts refusals;
    private final Timeline timeline;
    private final List<LoggedEvent> events = new ArrayList<>();
    private final FileExports exports;
    private volatile String notice = "";
    private volatile long noticeNanos;
    private WindowSnapshot newest;

    public ReplayModel(ReplayThread replay, RefusalTexts refusals) {
        this.replay = replay;
        this.refusals = refusals;
        Recording recording = replay.recording();
        timeline = new Timeline(recording.firstNanos(), recording.lastNanos(), recording.markers());
        for (RecordedEvent event : recording.events()) {
            ReplayedEvents.of(event).ifPresent(events::add);
        }
        exports = new FileExports(robot -> RecordedTrack.csv(recording.path(), robot), new WorldPictures());
    }

    private String damage() {
        return replay.recording().damage().map(refusals::damaged).orElse("");
    }

    /** The newest snapshot; the same object as long as nothing has changed. For the event thread only. */
    public WindowSnapshot snapshot() {
        SimulationSnapshot scene = replay.snapshot();
        WindowSnapshot now = new WindowSnapshot(
                scene,
                List.of(),
                replay.speed(),
                replay.isPaused(),
                replay.recording().path(),
                System.nanoTime() - noticeNanos < NOTICE_NANOS ? notice : damage(),
                List.of(),
                until(scene.timeNanos()),
                Optional.of(timeline),
                Optional.empty(),
                false);
        if (!now.equals(newest)) {
            newest = now;
        }
        return newest;
    }

    /** The events up to then; the same list as long as there are no more. */
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
        return newest != null && newest.events().size() == low ? newest.events() : List.copyOf(events.subList(0, low));
    }

    // ---- looking ---------------------------------------------------------------------------------------------------

    @Override
    public void seek(long nanos) {
        replay.seek(nanos);
    }

    @Override
    public void setSpeed(double simulatedSecondsPerSecond) {
        replay.setSpeed(simulatedSecondsPerSecond);
    }

    @Override
    public void setPaused(boolean paused) {
        replay.setPaused(paused);
    }

    @Override
    public void stepOnce() {
        replay.stepOnce();
    }

    @Override
    public void watch(String robot) {
        replay.watch(robot == null ? "" : robot);
    }

    @Override
    public void tell(String message) {
        noticeNanos = System.nanoTime();
        notice = message;
    }

    /** Pictures show the present moment; a track goes from the recording's beginning to its end. */
    @Override
    public void export(String robot, Path file, Consumer<Optional<String>> answer) {
        exports.export(
                replay.snapshot(),
                robot,
                file,
                ReplayModel::startDaemon,
                failure -> answer.accept(failure.map(why -> refusals.unwritable(file, why))));
    }

    private static void startDaemon(Runnable act) {
        Thread thread = new Thread(act, "export");
        thread.setDaemon(true);
        thread.start();
    }

    // ---- what a recording refuses -----------------------------------------------------------------------------------

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
