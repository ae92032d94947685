import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/**
 * Looks for a wall and keeps it half a metre to its right.
 *
 * The sonars are numbered clockwise from the left: 0 looks left, 3 and 4 ahead, 7 right.
 */
public class WallFollower implements Behaviour {
    /** The wanted distance between sonar and wall, in metres. */
    private static final double KEEP = 0.4;

    /** Metres per second. */
    private static final double SPEED = 0.25;

    private boolean turning;
    private double before = 5;

    @Override
    public Steering decide(Senses senses) {
        double ahead = senses.nearestMeters(2, 5);
        double right = senses.nearestMeters(6, 8);

        // How much nearer or farther the wall has come since the last decision: this damps the steering.
        double change = right - before;
        before = right;

        // Something is in the way: turn left on the spot until the way is free over 0.7 m.
        turning = senses.isBlocked() || ahead < (turning ? 0.7 : 0.45);
        if (turning) {
            return Steering.ofDegrees(0, 40);
        }

        // No wall: a bend to the right leads back to it, round a corner for example.
        if (right > 1.2) {
            return Steering.ofDegrees(0.7 * SPEED, -30);
        }

        // Too near: steer left (positive degrees). Too far: steer right.
        double degreesPerSecond = 70 * (KEEP - right) - 1600 * change;
        return Steering.ofDegrees(SPEED, Math.max(-30, Math.min(30, degreesPerSecond)));
    }
}
