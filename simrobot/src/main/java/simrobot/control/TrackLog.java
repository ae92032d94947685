package simrobot.control;

import java.util.HashMap;
import java.util.Map;
import simrobot.robot.Pioneer;
import simrobot.simulation.Simulation;
import vericommand.Pose;
import vericommand.RobotStatus;

/**
 * The tracks of all robots, sampled ten times per simulated second while they change; at most 2 000 000 samples, the
 * oldest are dropped. Filled on the simulation's thread, read by any.
 */
public final class TrackLog {
    private record Followed(Pioneer robot, TrackSeries series) {}

    private static final int MAX_SAMPLES = 2_000_000;
    private static final int MIN_SAMPLES_PER_ROBOT = 1000;

    private final Simulation simulation;
    private final int maxSamples;
    private final Map<String, Followed> tracks = new HashMap<>();

    TrackLog(Simulation simulation) {
        this(simulation, MAX_SAMPLES);
    }

    /** @param maxSamples maximum for all robots together */
    TrackLog(Simulation simulation, int maxSamples) {
        this.simulation = simulation;
        this.maxSamples = maxSamples;
        simulation.addStepListener(this::step);
    }

    /** Starts the track of a robot; replaces an earlier track of the same name. */
    synchronized void follow(Pioneer robot) {
        Followed track = new Followed(robot, new TrackSeries());
        tracks.put(robot.name(), track);
        statusChanged(track, robot.status());
        robot.addStatusListener(status -> statusChanged(track, status));
    }

    /** Drops the track of a robot that was removed. */
    synchronized void forget(Pioneer robot) {
        tracks.remove(robot.name());
    }

    private synchronized void statusChanged(Followed track, RobotStatus status) {
        track.series.add(simulation.timeNanos(), track.robot.pose(), status, samplesPerRobot());
    }

    private synchronized void step(long timeNanos) {
        if (timeNanos % TrackSeries.PERIOD_NANOS == 0) {
            for (Followed track : tracks.values()) {
                Pose pose = track.robot.pose();
                RobotStatus status = track.robot.status();
                if (track.series.isNews(pose, status)) {
                    track.series.add(timeNanos, pose, status, samplesPerRobot());
                }
            }
        }
    }

    private int samplesPerRobot() {
        return Math.max(MIN_SAMPLES_PER_ROBOT, maxSamples / Math.max(1, tracks.size()));
    }

    /** Returns a robot's samples so far; empty if no robot has that name. Callable on any thread. */
    synchronized TrackSeries.Samples samples(String robot) {
        Followed track = tracks.get(robot);
        return (track == null ? new TrackSeries() : track.series).samples();
    }

    /** Returns the samples as CSV. Callable on any thread; formats without holding the lock that each step takes. */
    public String csv(String robot) {
        return samples(robot).csv();
    }
}
