package simrobot.behaviour;

/** A robot's measurements at one moment. Metres, radians anticlockwise, seconds. */
public interface Senses {
    /** The number of sonars. */
    int SONARS = 16;

    /** The number of readings of the laser. */
    int LASER_READINGS = 181;

    /**
     * The range of one sonar, 0.1 to 5 m; 5 m also without an echo. The eight sonars of an array fire in turn, so the
     * value is up to 320 ms old.
     *
     * @param sonar 0 to 15, clockwise: 0 looks to the left, 3 and 4 ahead, 7 to the right, 11 and 12 back
     */
    double sonarMeters(int sonar);

    /**
     * The range of one reading of the laser, 0 to 32 m; 32 m also without an obstacle.
     *
     * @param reading 0 to 180, anticlockwise by the degree: 0 looks to the right, 90 ahead, 180 to the left
     */
    double laserMeters(int reading);

    /** Result of {@link #key} while the caller presses no key. */
    char NO_KEY = ' ';

    /** The true x coordinate in the world. */
    double xMeters();

    /** The true y coordinate in the world. */
    double yMeters();

    /** The true heading, anticlockwise from +X, in (-pi, pi]. */
    double headingRadians();

    /** The place by the turns of the wheels alone, which slip; the true one when the process began. */
    OdometryPose odometry();

    /** Speed of the wheels, negative back. */
    double metersPerSecond();

    /** True while a collision keeps the robot from moving; it may turn and back away. */
    boolean isBlocked();

    /**
     * True while a front bumper is pressed.
     *
     * @param bumper 0 to 4, from the left to the right
     */
    boolean isFrontBumperPressed(int bumper);

    /**
     * True while a rear bumper is pressed.
     *
     * @param bumper 0 to 4, from the right to the left
     */
    boolean isRearBumperPressed(int bumper);

    /** Simulated time since the process began. */
    double seconds();

    /** True once {@link Behaviour#goTo} has reached its place, until another place is requested. */
    boolean hasArrived();

    /** The robot's telephone. */
    Call call();

    /**
     * The key that the caller holds, or has pressed since the last decision; {@link #NO_KEY} if none. Only the call in
     * which {@code #*n} started the process delivers keys; two stars begin an order and end the process.
     */
    default char key() {
        if (BehaviourAnswer.isOpen()) {
            BehaviourAnswer.ask(new BehaviourRequest.Keys());
        }
        return call().key();
    }

    /** The number that called, or started the process by SMS, last; empty if there is none. */
    default String caller() {
        return call().caller();
    }

    /**
     * The smallest range of neighbouring sonars.
     *
     * @param first the first and last sonar
     */
    default double nearestMeters(int first, int last) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int sonar = first; sonar <= last; sonar++) {
            nearest = Math.min(nearest, sonarMeters(sonar));
        }
        return nearest;
    }
}
