package simrobot.behaviour;

/**
 * Goes ahead until something is near, then turns for a second, robots of even number to the left, of odd number to the
 * right. The rule of the speed comparison with other simulators, so its numbers are not ours to choose.
 */
public final class Wander implements Behaviour {
    /** The sonars that look ahead, from 50 degrees left to 50 degrees right. */
    private static final int FIRST_SONAR = 1;

    private static final int LAST_SONAR = 6;
    private static final double NEAR_METERS = 0.5;
    private static final int AVOIDING_TICKS = 10;
    /** Its speed ahead; it has no other. */
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
    public Steering decide(SonarRanges sonars, boolean blocked) {
        if (ticksToAvoid == 0 && (blocked || isNear(sonars))) {
            ticksToAvoid = AVOIDING_TICKS;
        }
        if (ticksToAvoid == 0) {
            return AHEAD;
        }
        ticksToAvoid--;
        return avoiding;
    }

    private static boolean isNear(SonarRanges sonars) {
        for (int i = FIRST_SONAR; i <= LAST_SONAR; i++) {
            if (sonars.meters(i) < NEAR_METERS) {
                return true;
            }
        }
        return false;
    }
}
