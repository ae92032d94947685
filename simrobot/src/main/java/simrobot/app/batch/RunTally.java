package simrobot.app.batch;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import simrobot.control.TrackSeries;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import vericommand.RobotStatus;

/** Sums up one run of {@code --runs} as a line of CSV. */
final class RunTally {
    static final String HEADER = "seed,robots,simulated,travelled,collisions,moving";

    private final List<SimulatedRobot> robots;
    /** x and y of each robot, in metres, 0.1 s ago. */
    private final double[] places;

    private double travelledMeters;
    private long collisions;
    private long movingSamples;
    private long samples;

    RunTally(Simulation simulation) {
        robots = List.copyOf(simulation.robots());
        places = new double[2 * robots.size()];
        Arrays.setAll(places, this::coordinate);
        for (SimulatedRobot robot : robots) {
            robot.addStatusListener(status -> collisions += status == RobotStatus.COLLISION ? 1 : 0);
        }
        simulation.addStepListener(this::stepped);
    }

    private double coordinate(int index) {
        SimulatedRobot robot = robots.get(index / 2);
        return index % 2 == 0 ? robot.xMeters() : robot.yMeters();
    }

    private void stepped(long timeNanos) {
        if (timeNanos % TrackSeries.PERIOD_NANOS != 0) {
            return;
        }
        for (int i = 0; i < robots.size(); i++) {
            double x = coordinate(2 * i);
            double y = coordinate(2 * i + 1);
            travelledMeters += Math.hypot(x - places[2 * i], y - places[2 * i + 1]);
            places[2 * i] = x;
            places[2 * i + 1] = y;
            movingSamples += robots.get(i).status() == RobotStatus.MOVING ? 1 : 0;
            samples++;
        }
    }

    /** Returns metres of all robots together, collisions, and the share of time in motion. */
    String line(long seed, double seconds) {
        return String.format(
                Locale.ROOT,
                "%d,%d,%.3f,%.3f,%d,%.4f",
                seed,
                robots.size(),
                seconds,
                travelledMeters,
                collisions,
                samples == 0 ? 0 : (double) movingSamples / samples);
    }
}
