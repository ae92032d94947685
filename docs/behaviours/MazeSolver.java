import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/**
 * Finds the finish of worlds/maze.map by the oldest rule for mazes: keep your right hand on the wall. No lamp marks the
 * finish; the robot sees with its laser, and knows from its pose when it has arrived.
 *
 * The laser's readings are numbered anticlockwise by the degree: 0 looks right, 90 ahead, 180 left.
 */
public class MazeSolver implements Behaviour {
    /** Half the width of a way in this maze, in metres: the middle of the way. */
    private static final double KEEP = 0.6;

    private static final double FINISH_X = 14.25;
    private static final double FINISH_Y = 14.25;

    private boolean turning;
    private boolean finished;

    @Override
    public Steering decide(Senses senses) {
        finished = Math.hypot(FINISH_X - senses.xMeters(), FINISH_Y - senses.yMeters()) < 0.5;
        if (finished) {
            return Steering.STOP;
        }

        double ahead = nearest(senses, 70, 110);
        turning = senses.isBlocked() || ahead < (turning ? 1.0 : 0.6);
        if (turning) {
            return Steering.ofDegrees(0, 50);
        }

        // The wall at the right ends: round its end with a bend.
        double right = nearest(senses, 0, 40);
        if (right > 1.1) {
            return Steering.ofDegrees(0.25, -25);
        }

        // Two readings tell how the robot stands to the wall: alongside it, the one 40 degrees ahead of the right
        // measures right / cos(40 degrees).
        double slant = senses.laserMeters(40) * Math.cos(Math.toRadians(40)) - senses.laserMeters(0);
        double steer = 40 * (KEEP - right) - 60 * Math.max(-0.5, Math.min(0.5, slant));
        return Steering.ofDegrees(0.3, Math.max(-40, Math.min(40, steer)));
    }

    /** The process ends here: an order that started it is answered by 3. */
    @Override
    public boolean isDone() {
        return finished;
    }

    private static double nearest(Senses senses, int first, int last) {
        double nearest = 32;
        for (int reading = first; reading <= last; reading++) {
            nearest = Math.min(nearest, senses.laserMeters(reading));
        }
        return nearest;
    }
}
