package simrobot.behaviour;

/** What a robot measures at one moment. Metres, radians anticlockwise, seconds. */
public interface Senses {
    /** The number of sonars. */
    int SONARS = 16;

    /** The number of readings of the laser. */
    int LASER_READINGS = 181;

    /**
     * The range of one sonar, 0.1 to 5 m, 5 m also where there is no echo: as it was when the sonar last fired, up to 320 ms
     * ago, for the eight of an array fire in turn.
     *
     * @param sonar 0 to 15, clockwise: 0 looks to the left, 3 and 4 ahead, 7 to the right, 11 and 12 back
     */
    double sonarMeters(int sonar);

    /**
     * The range of one reading of the laser, 0 to 32 m; 32 m also where there is nothing.
     *
     * @param reading 0 to 180, anticlockwise by the degree: 0 looks to the right, 90 ahead, 180 to the left
     */
    double laserMeters(int reading);

    /** {@link #key} while the caller presses none. */
    char NO_KEY = ' ';

    /** The true place in the world. */
    double xMeters();

    /** The true place in the world. */
    double yMeters();

    /** The true heading, anticlockwise from +X, in (-pi, pi]. */
    double headingRadians();

    /** The place by the turns of the wheels alone, which slip; the true one when the process began. */
    Place odometry();

    /** Speed of the wheels, negative back. */
    double metersPerSecond();

    /** True while a collision keeps the robot from moving; it may turn and back away. */
    boolean isBlocked();

    /** Whether a front bumper is pressed. @param bumper 0 to 4, from the left to the right */
    boolean isFrontBumperPressed(int bumper);

    /** Whether a rear bumper is pressed. @param bumper 0 to 4, from the right to the left */
    boolean isRearBumperPressed(int bumper);

    /** Simulated time since the process began. */
    double seconds();

    /** True once {@link Behaviour#goTo} has come to its place, until another place is asked for. */
    boolean hasArrived();

    /** The robot's telephone. */
    Call call();

    /**
     * The key that the caller holds down, or has pressed since the last decision; {@link #NO_KEY} if none. Keys come while the
     * call is up in which {@code #*n} started the process; two stars begin an order and end the process.
     */
    default char key() {
        if (Answer.isOpen()) {
            Answer.ask(new Request.Keys());
        }
        return call().key();
    }

    /** The number that called, or started the process by SMS, last; empty if there is none. */
    default String caller() {
        return call().caller();
    }

    /** The least range of several neighbouring sonars. @param first with the next one the numbers of the outer two */
    default double nearestMeters(int first, int last) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int sonar = first; sonar <= last; sonar++) {
            nearest = Math.min(nearest, sonarMeters(sonar));
        }
        return nearest;
    }
}
