package simrobot.process;

import simrobot.behaviour.Behaviour;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;

/**
 * Drives ahead until an obstacle is near, then turns for 1 s: robots with even numbers left, with odd numbers right.
 * The speed comparison with other simulators prescribes this rule and its numbers.
 */
public final class Wander implements Behaviour {
    /** The forward sonars, from 50 degrees left to 50 degrees right. */
    private static final int FIRST_SONAR = 1;

    private static final int LAST_SONAR = 6;
    private static final double NEAR_METERS = 0.5;
    private static final int AVOIDING_TICKS = 10;
    /** The only speed ahead. */
    public static final double METERS_PER_SECOND = 0.4;

    private static final double RADIANS_PER_SECOND = Math.toRadians(50);

    private static final Steering AHEAD = new Steering(METERS_PER_SECOND, 0);
    private static final Steering LEFT = new Steering(0, RADIANS_PER_SECOND);
    private static final Steering RIGHT = new Steering(0, -RADIANS_PER_SECOND);

    private final Steering avoiding;
    private int ticksToAvoid;

    public Wander(int robotNumber) {
        avoiding = robotNumber % 2 == 0 ? LEFT : RIGHT;
    }

    @Override
    public Steering decide(Senses senses) {
        if (ticksToAvoid == 0 && (senses.isBlocked() || isNear(senses))) {
            ticksToAvoid = AVOIDING_TICKS;
        }
        if (ticksToAvoid == 0) {
            return AHEAD;
        }
        ticksToAvoid--;
        return avoiding;
    }

    private static boolean isNear(Senses senses) {
        for (int i = FIRST_SONAR; i <= LAST_SONAR; i++) {
            if (senses.sonarMeters(i) < NEAR_METERS) {
                return true;
            }
        }
        return false;
    }
}
