package simrobot.control;

import java.util.HashMap;
import java.util.Map;
import simrobot.robot.Pioneer;
import simrobot.simulation.Simulation;

/**
 * Where every robot has been and in which status, ten times a simulated second while something changes; bounded, the oldest
 * make room. Filled on the simulation's thread, read by any.
 */
public final class TrackLog {
    private record Followed(Pioneer robot, TrackSeries series) {}

    private static final int MOST_SAMPLES = 2_000_000;
    private static final int LEAST_SAMPLES_OF_A_ROBOT = 1000;

    private final Simulation simulation;
    private final int mostSamples;
    private final Map<String, Followed> tracks = new HashMap<>();

    TrackLog(Simulation simulation) {
        this(simulation, MOST_SAMPLES);
    }

    /** @param mostSamples of all robots together */
    TrackLog(Simulation simulation, int mostSamples) {
        this.simulation = simulation;
        this.mostSamples = mostSamples;
        simulation.addStepListener(this::step);
    }

    /** Follows a robot from now on; one of the same name that was there before is forgotten. */
    synchronized void follow(Pioneer robot) {
        Followed track = new Followed(robot, new TrackSeries());
        tracks.put(robot.name(), track);
        changed(track);
        robot.addStatusListener(status -> changed(track));
    }

    /** A robot that has left has no track any more. */
    synchronized void forget(Pioneer robot) {
        tracks.remove(robot.name());
    }

    private synchronized void changed(Followed track) {
        Pioneer robot = track.robot;
        track.series.take(simulation.timeNanos(), robot.pose(), robot.status(), room());
    }

    private synchronized void step(long timeNanos) {
        if (timeNanos % TrackSeries.PERIOD_NANOS == 0) {
            int room = room();
            for (Followed track : tracks.values()) {
                Pioneer robot = track.robot;
                if (track.series.isNews(robot.pose(), robot.status())) {
                    track.series.take(timeNanos, robot.pose(), robot.status(), room);
                }
            }
        }
    }

    private int room() {
        return Math.max(LEAST_SAMPLES_OF_A_ROBOT, mostSamples / Math.max(1, tracks.size()));
    }

    /** A robot's track; only the columns' names when there is none of that name. Any thread may ask. */
    public synchronized String csv(String robot) {
        Followed track = tracks.get(robot);
        return (track == null ? new TrackSeries() : track.series).csv();
    }
}
