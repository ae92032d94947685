package simrobot.app.window;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import simrobot.control.TrackSeries;
import simrobot.replay.DamagedException;
import simrobot.replay.Recording;
import simrobot.replay.ReplayCursor;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;

/** A robot's whole track from a recording, read with its own cursor. */
final class RecordedTrack {
    private static final int MAX_SAMPLES = 10_000_000;

    private final String robot;
    private final TrackSeries series = new TrackSeries();
    private boolean present;

    private RecordedTrack(String robot) {
        this.robot = robot;
    }

    /** The columns of {@link TrackSeries.Samples#writeCsv}; damage ends the track. */
    static String csv(Path recording, String robot) throws IOException {
        RecordedTrack track = new RecordedTrack(robot);
        try (Recording opened = Recording.open(recording)) {
            ReplayCursor cursor = new ReplayCursor(opened);
            long nanos = opened.firstNanos();
            while (nanos <= opened.lastNanos()) {
                cursor.seek(nanos);
                track.look(cursor);
                nanos += Simulation.STEP_NANOS;
            }
        } catch (DamagedException e) {
            throw new IOException(recording + ": " + e.getMessage(), e);
        }
        return track.series.samples().csv();
    }

    private void look(ReplayCursor cursor) {
        Optional<SimulatedRobot> found = cursor.robots().stream()
                .filter(each -> each.name().equals(robot))
                .findFirst();
        found.ifPresent(here -> sample(cursor.timeNanos(), here));
        present = found.isPresent();
    }

    private void sample(long nanos, SimulatedRobot here) {
        if (!present) {
            series.append(nanos, here.pose(), here.status(), MAX_SAMPLES);
        } else if (series.isNews(here.status())
                || nanos % TrackSeries.PERIOD_NANOS == 0 && series.isNews(here.pose(), here.status())) {
            series.add(nanos, here.pose(), here.status(), MAX_SAMPLES);
        }
    }
}
