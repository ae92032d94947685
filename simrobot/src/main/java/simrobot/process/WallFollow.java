package simrobot.process;

import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/**
 * Follows a wall on the right. A robot with an obstacle ahead turns left on the spot. Otherwise it controls its
 * distance from the wall by the nearest echo on the right, and its angle to the wall by the two sonars on the right,
 * which fire one after the other. At the wall's end it turns right round the corner. It drives straight ahead until it
 * finds a wall.
 */
public final class WallFollow implements Behaviour {
    /** Distance kept from the sonars, about 0.14 m from the robot's centre. */
    static final double KEPT_METERS = 0.4;

    private static final double BLOCKED_METERS = 0.45;
    private static final double CLEAR_METERS = 0.7;
    private static final double LOST_METERS = 1.2;
    private static final double METERS_PER_SECOND = 0.25;
    private static final double SPIN_RADIANS_PER_SECOND = Math.toRadians(40);
    private static final double BEND_RADIANS_PER_SECOND = Math.toRadians(30);
    private static final double BEND_PER_METER = 1.2;
    private static final double BEND_PER_RADIAN = 0.6;

    /** The right-hand sonars, and their distance along the robot. */
    private static final int FRONT_RIGHT = 7;

    private static final int REAR_RIGHT = 8;
    private static final double BASE_METERS = 0.226;

    private static final Steering SPIN_LEFT = new Steering(0, SPIN_RADIANS_PER_SECOND);
    private static final Steering STRAIGHT = new Steering(METERS_PER_SECOND, 0);
    private static final Steering ROUND_THE_CORNER = new Steering(METERS_PER_SECOND * 0.7, -BEND_RADIANS_PER_SECOND);

    private boolean hasFound;
    private boolean spins;

    /** Creates a process that has found no wall yet. */
    public WallFollow() {}

    @Override
    public Steering decide(Senses senses) {
        double ahead = senses.nearestMeters(2, 5);
        double right = senses.nearestMeters(6, 8);
        spins = senses.isBlocked() || ahead < (spins ? CLEAR_METERS : BLOCKED_METERS);
        if (spins) {
            hasFound = true;
            return SPIN_LEFT;
        }
        if (right > LOST_METERS) {
            return hasFound ? ROUND_THE_CORNER : STRAIGHT;
        }
        hasFound = true;
        double bend = (KEPT_METERS - right) * BEND_PER_METER - angleRadians(senses) * BEND_PER_RADIAN;
        double within = Math.max(-BEND_RADIANS_PER_SECOND, Math.min(BEND_RADIANS_PER_SECOND, bend));
        return new Steering(METERS_PER_SECOND, within);
    }

    /** Angle of the robot to the wall, positive away from it; 0 unless both sonars see the wall. */
    private static double angleRadians(Senses senses) {
        double front = senses.sonarMeters(FRONT_RIGHT);
        double rear = senses.sonarMeters(REAR_RIGHT);
        return Math.max(front, rear) > LOST_METERS ? 0 : Math.atan((front - rear) / BASE_METERS);
    }
}
