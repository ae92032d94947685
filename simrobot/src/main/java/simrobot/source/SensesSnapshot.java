package simrobot.source;

import java.util.stream.IntStream;
import simrobot.behaviour.Call;
import simrobot.behaviour.Place;
import simrobot.behaviour.Senses;

/**
 * Senses at one moment, for another thread.
 *
 * @param laser null if the robot has none
 * @param bumpers true if pressed: the front ones, then the rear ones
 */
record SensesSnapshot(
        double[] sonars,
        double[] laser,
        boolean[][] bumpers,
        double xMeters,
        double yMeters,
        double headingRadians,
        double metersPerSecond,
        boolean isBlocked,
        double seconds,
        Place odometry,
        boolean hasArrived,
        Call call)
        implements Senses {
    private static final int BUMPERS = 5;

    /** @param live read on the thread that owns the robot */
    static SensesSnapshot of(Senses live) {
        boolean[][] bumpers = new boolean[2][BUMPERS];
        for (int i = 0; i < BUMPERS; i++) {
            bumpers[0][i] = live.isFrontBumperPressed(i);
            bumpers[1][i] = live.isRearBumperPressed(i);
        }
        return new SensesSnapshot(
                IntStream.range(0, SONARS).mapToDouble(live::sonarMeters).toArray(),
                laser(live),
                bumpers,
                live.xMeters(),
                live.yMeters(),
                live.headingRadians(),
                live.metersPerSecond(),
                live.isBlocked(),
                live.seconds(),
                live.odometry(),
                live.hasArrived(),
                live.call());
    }

    private static double[] laser(Senses live) {
        try {
            return IntStream.range(0, LASER_READINGS)
                    .mapToDouble(live::laserMeters)
                    .toArray();
        } catch (UnsupportedOperationException none) {
            return null;
        }
    }

    @Override
    public double sonarMeters(int sonar) {
        return sonars[sonar];
    }

    @Override
    public double laserMeters(int reading) {
        if (laser == null) {
            throw new UnsupportedOperationException("this robot has no laser, expected sonarMeters");
        }
        return laser[reading];
    }

    @Override
    public boolean isFrontBumperPressed(int bumper) {
        return bumpers[0][bumper];
    }

    @Override
    public boolean isRearBumperPressed(int bumper) {
        return bumpers[1][bumper];
    }
}
