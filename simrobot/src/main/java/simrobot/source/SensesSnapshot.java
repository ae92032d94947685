package simrobot.source;

import simrobot.behaviour.Senses;

/** Senses at one moment, for another thread. */
final class SensesSnapshot implements Senses {
    private static final int BUMPERS = 5;

    private final double[] sonars = new double[SONARS];
    /** Null if the robot has none. */
    private final double[] laser;

    private final boolean[] front = new boolean[BUMPERS];
    private final boolean[] rear = new boolean[BUMPERS];
    private final double x;
    private final double y;
    private final double heading;
    private final double speed;
    private final boolean blocked;
    private final double seconds;

    /** @param live read on the thread that owns the robot */
    SensesSnapshot(Senses live) {
        for (int i = 0; i < sonars.length; i++) {
            sonars[i] = live.sonarMeters(i);
        }
        laser = laser(live);
        for (int i = 0; i < BUMPERS; i++) {
            front[i] = live.isFrontBumperPressed(i);
            rear[i] = live.isRearBumperPressed(i);
        }
        x = live.xMeters();
        y = live.yMeters();
        heading = live.headingRadians();
        speed = live.metersPerSecond();
        blocked = live.isBlocked();
        seconds = live.seconds();
    }

    private static double[] laser(Senses live) {
        double[] ranges = new double[LASER_READINGS];
        try {
            for (int i = 0; i < ranges.length; i++) {
                ranges[i] = live.laserMeters(i);
            }
            return ranges;
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
    public double xMeters() {
        return x;
    }

    @Override
    public double yMeters() {
        return y;
    }

    @Override
    public double headingRadians() {
        return heading;
    }

    @Override
    public double metersPerSecond() {
        return speed;
    }

    @Override
    public boolean isBlocked() {
        return blocked;
    }

    @Override
    public boolean isFrontBumperPressed(int bumper) {
        return front[bumper];
    }

    @Override
    public boolean isRearBumperPressed(int bumper) {
        return rear[bumper];
    }

    @Override
    public double seconds() {
        return seconds;
    }
}
