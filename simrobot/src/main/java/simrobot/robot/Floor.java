package simrobot.robot;

import simrobot.world.Cone;
import simrobot.world.Contact;

/** What surrounds a robot: walls, belts and the other robots. Implemented by the simulation. */
public interface Floor {
    /** What a robot meets on its way. */
    record Encounter(Contact contact, SimulatedRobot robot) {
        /** Nothing. */
        public static final Encounter NONE = new Encounter(Contact.NONE, null);

        /** True when it is another robot that is touched. */
        public boolean isRobot() {
            return robot != null;
        }
    }

    /** The first thing that this robot's circle touches on its way by (dx, dy) metres. */
    Encounter sweep(SimulatedRobot robot, double dx, double dy);

    /** True when the robot's circle, with its centre there, would overlap nothing. */
    boolean isFree(SimulatedRobot robot, double xMeters, double yMeters);

    /** True when the place lies within the world. */
    boolean isInside(double xMeters, double yMeters);

    /** How fast the floor itself moves there, metres per second along x. */
    double beltVelocityX(double xMeters, double yMeters);

    /** How fast the floor itself moves there, metres per second along y. */
    double beltVelocityY(double xMeters, double yMeters);

    /**
     * The distance along a single ray from (x, y) to something other than this robot, or the range; metres.
     *
     * @param ux with uy the ray's direction, a unit vector
     */
    double rayRange(SimulatedRobot robot, double x, double y, double ux, double uy, double rangeMeters);

    /** The distance at which the cone first holds something other than this robot, or the range. */
    double coneRange(SimulatedRobot robot, Cone cone, double rangeMeters);

    /** Tells that the robot's place has changed. */
    void moved(SimulatedRobot robot);
}
