import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/**
 * Looks for a wall and keeps it half a metre to its right.
 *
 * The sonars are numbered clockwise from the left: 0 looks left, 3 and 4 ahead, 7 and 8 right, 7 in front of 8. They fire in
 * turn, so that a range may be 0.3 s old.
 */
public class KeepWall implements Behaviour {
    /** The wanted distance between sonar and wall, in metres. */
    private static final double KEEP = 0.4;

    /** Metres per second. */
    private static final double SPEED = 0.25;

    private boolean turning;

    @Override
    public Steering decide(Senses senses) {
        double ahead = senses.nearestMeters(2, 5);
        double right = senses.nearestMeters(6, 8);

        // The way is blocked: turn left on the spot until it is free over 0.7 m.
        turning = senses.isBlocked() || ahead < (turning ? 0.7 : 0.45);
        if (turning) {
            return Steering.ofDegrees(0, 40);
        }

        // No wall: a bend to the right leads back to it, round a corner for example.
        if (right > 1.2) {
            return Steering.ofDegrees(0.7 * SPEED, -30);
        }

        // The front sonar sees the wall farther away than the rear one: the robot points away from it, and should turn back.
        double away = senses.sonarMeters(7) - senses.sonarMeters(8);

        // Too near: steer left (positive degrees). Too far: steer right. The second part damps the first.
        double degreesPerSecond = 70 * (KEEP - right) - 200 * Math.max(-0.2, Math.min(0.2, away));
        return Steering.ofDegrees(SPEED, Math.max(-30, Math.min(30, degreesPerSecond)));
    }
}
