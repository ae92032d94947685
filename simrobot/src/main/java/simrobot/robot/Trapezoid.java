package simrobot.robot;

/**
 * The fastest way to come to rest exactly at a goal under a limit of speed and one of acceleration: up, along, down. In
 * closed form over any stretch of time, so steps add up to the profile without drift.
 *
 * <pre>
 *   speed   ____________          ____
 *          /            \   or   /    \   or, when short,  /\
 *         /              \      /      \                  /  \
 * </pre>
 *
 * The unit of way is free: metres here, radians there.
 *
 * @param top the greatest speed
 * @param acceleration of gaining speed
 * @param deceleration of losing speed
 */
public record Trapezoid(double top, double acceleration, double deceleration) {
    public static final Trapezoid FORWARD =
            new Trapezoid(Pioneer2Dx.TOP_SPEED_METERS_PER_SECOND, Pioneer2Dx.ACCELERATION_METERS_PER_SECOND2);
    public static final Trapezoid TURN =
            new Trapezoid(Pioneer2Dx.TOP_TURN_RADIANS_PER_SECOND, Pioneer2Dx.TURN_ACCELERATION_RADIANS_PER_SECOND2);

    /** Rounding may ask for this much more than the acceleration to land on the goal; beyond it the goal is overrun. */
    private static final double LANDING_TOLERANCE = 1.001;

    public Trapezoid {
        if (!(top > 0 && acceleration > 0 && deceleration > 0)) {
            throw new IllegalArgumentException("top speed " + top + ", acceleration " + acceleration
                    + " and deceleration " + deceleration + ", expected all above 0");
        }
    }

    /** One limit for gaining and for losing speed. */
    public Trapezoid(double top, double acceleration) {
        this(top, acceleration, acceleration);
    }

    /** Where a stretch of time leads: the way made and the speed at its end. */
    public record Stretch(double way, double speed) {}

    /** From rest to rest over this way, in seconds. */
    public double seconds(double way) {
        double slope = (1 / acceleration + 1 / deceleration) / 2;
        double ramps = top * top * slope;
        return way < ramps ? 2 * Math.sqrt(way * slope) : way / top + top * slope;
    }

    /**
     * The next stretch towards a goal.
     *
     * @param speed now, 0 or more; above the top it is first brought down to it
     * @param remaining way to the goal; 0 or less brakes
     * @param dt seconds
     */
    public Stretch towards(double remaining, double speed, double dt) {
        double needed = remaining > 0 ? speed * speed / (2 * remaining) : Double.POSITIVE_INFINITY;
        if (speed > 0 && needed >= deceleration / LANDING_TOLERANCE) {
            return needed <= deceleration * LANDING_TOLERANCE ? land(remaining, speed, needed, dt) : brake(speed, dt);
        }
        if (remaining <= 0) {
            return new Stretch(0, 0);
        }
        if (speed > top) {
            return slowToTop(remaining, speed, dt);
        }
        double peak = Math.min(top, peak(remaining, speed));
        double rampUp = Math.max(0, (peak - speed) / acceleration);
        if (dt <= rampUp) {
            return new Stretch((speed + acceleration * dt / 2) * dt, speed + acceleration * dt);
        }
        double upWay = (speed + peak) / 2 * rampUp;
        double downWay = peak * peak / (2 * deceleration);
        double cruise = Math.max(0, (remaining - upWay - downWay) / peak);
        if (dt <= rampUp + cruise) {
            return new Stretch(upWay + peak * (dt - rampUp), peak);
        }
        double before = upWay + peak * cruise;
        Stretch down = land(remaining - before, peak, deceleration, dt - rampUp - cruise);
        return down.speed() == 0 ? new Stretch(remaining, 0) : new Stretch(before + down.way(), down.speed());
    }

    /** The speed at which gaining must turn into losing to land on the goal. */
    private double peak(double remaining, double speed) {
        return acceleration == deceleration
                ? Math.sqrt(acceleration * remaining + speed * speed / 2)
                : Math.sqrt((2 * remaining + speed * speed / acceleration) / (1 / acceleration + 1 / deceleration));
    }

    private Stretch slowToTop(double remaining, double speed, double dt) {
        double seconds = (speed - top) / deceleration;
        if (dt <= seconds) {
            return new Stretch((speed - deceleration * dt / 2) * dt, speed - deceleration * dt);
        }
        double way = (speed + top) / 2 * seconds;
        Stretch rest = towards(remaining - way, top, dt - seconds);
        return new Stretch(way + rest.way(), rest.speed());
    }

    /** Loses speed as fast as it may. */
    public Stretch brake(double speed, double dt) {
        double seconds = speed / deceleration;
        return dt >= seconds
                ? new Stretch(speed * seconds / 2, 0)
                : new Stretch((speed - deceleration * dt / 2) * dt, speed - deceleration * dt);
    }

    private static Stretch land(double remaining, double speed, double deceleration, double dt) {
        // times below a nanosecond are rounding, not motion
        return dt >= speed / deceleration - 1e-9
                ? new Stretch(remaining, 0)
                : new Stretch((speed - deceleration * dt / 2) * dt, speed - deceleration * dt);
    }
}
