package simrobot.robot;

import simrobot.world.Contact;

/**
 * What was touched last, as the direction from there to the robot's centre.
 *
 * @param normalX with normalY a unit vector; both 0 when nothing was touched yet
 */
record ContactDirection(double normalX, double normalY) {
    static final ContactDirection NONE = new ContactDirection(0, 0);

    /** A bumper lets go within this way. */
    private static final double GRIP_METERS = 0.001;

    static ContactDirection of(Contact contact) {
        return new ContactDirection(contact.normalX(), contact.normalY());
    }

    boolean isSomething() {
        return normalX != 0 || normalY != 0;
    }

    ContactDirection opposite() {
        return new ContactDirection(-normalX, -normalY);
    }

    /** Whether something is still there. */
    boolean holds(SimulatedRobot robot, Floor floor) {
        return isSomething()
                && floor.sweep(robot, -normalX * GRIP_METERS, -normalY * GRIP_METERS)
                        .contact()
                        .touches();
    }

    /** Anticlockwise from ahead, in (-pi, pi]. */
    double bearing(double heading) {
        double bearing = StrictMath.atan2(-normalY, -normalX) - heading;
        return Math.IEEEremainder(bearing, 2 * Math.PI);
    }
}
