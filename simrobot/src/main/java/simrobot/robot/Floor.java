package simrobot.robot;

import java.util.List;
import simrobot.process.WaitBudget;
import simrobot.world.Cone;
import simrobot.world.Contact;
import simrobot.world.Position;
import simrobot.world.World;

/** The surroundings of a robot: walls, belts and the other robots. Implemented by the simulation. */
public interface Floor {
    /** The first contact on a robot's path, and the touched robot; null for other obstacles. */
    record Encounter(Contact contact, SimulatedRobot robot) {
        /** No contact. */
        public static final Encounter NONE = new Encounter(Contact.NONE, null);

        /** True if the obstacle is another robot. */
        public boolean isRobot() {
            return robot != null;
        }
    }

    /** The first contact of this robot's circle on a path by (dx, dy) metres. */
    Encounter sweep(SimulatedRobot robot, double dx, double dy);

    /** True if the robot's circle, with its centre there, overlaps nothing. @param robot null for a robot to be added */
    boolean isFree(SimulatedRobot robot, double xMeters, double yMeters);

    /** True if the place is inside the world. */
    boolean isInside(double xMeters, double yMeters);

    /** The robot's motion there per metre or radian of its wheels, 0 to 1. */
    double grip(double xMeters, double yMeters);

    /** Velocity of the floor there along x, metres per second. */
    double velocityX(double xMeters, double yMeters);

    /** Velocity of the floor there along y, metres per second. */
    double velocityY(double xMeters, double yMeters);

    /**
     * The distance along a single ray from (x, y) to something other than this robot, or the range; metres.
     *
     * @param ux with uy the ray's direction, a unit vector
     * @param moment of the sonar clock, which selects the other robots' positions
     */
    double rayRange(SimulatedRobot robot, double x, double y, double ux, double uy, double rangeMeters, int moment);

    /** The smallest distance at which the cone contains something other than this robot, or the range, at a moment. */
    double coneRange(SimulatedRobot robot, Cone cone, double rangeMeters, int moment);

    /** The firing times of sonars. */
    SonarClock sonarClock();

    /** The world of this floor. */
    World world();

    /** The time that all robots may wait in a step. */
    WaitBudget waitBudget();

    /** The positions of the robots other than this one. */
    List<Position> others(SimulatedRobot robot);

    /**
     * Called at the end of a robot's step.
     *
     * @param dx with dy the robot's motion in it, metres
     */
    void stepped(double dx, double dy);

    /** Called after a robot was placed, and not moved by a step; implies {@link #moved}. */
    void placed(SimulatedRobot robot);

    /** Called after a robot's position has changed. */
    void moved(SimulatedRobot robot);
}
