package simrobot.robot;

import simrobot.world.Contact;

/**
 * The direction from the last contact to the robot's centre.
 *
 * @param normalX with normalY a unit vector; both 0 before the first contact
 */
record ContactDirection(double normalX, double normalY) {
    static final ContactDirection NONE = new ContactDirection(0, 0);

    /** Distance of the obstacle at which a contact ends. */
    private static final double GRIP_METERS = 0.001;

    static ContactDirection of(Contact contact) {
        return new ContactDirection(contact.normalX(), contact.normalY());
    }

    boolean exists() {
        return normalX != 0 || normalY != 0;
    }

    ContactDirection opposite() {
        return new ContactDirection(-normalX, -normalY);
    }

    /** True if the obstacle is still in contact. */
    boolean persists(SimulatedRobot robot, Floor floor) {
        return exists()
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
