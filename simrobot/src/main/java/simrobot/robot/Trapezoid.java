package simrobot.robot;

/**
 * The velocity trapezoid: the fastest motion that comes to rest exactly at a goal under limits of speed, acceleration and
 * deceleration. Computed in closed form over any duration, so steps add up to the profile without drift.
 *
 * <pre>
 *   speed   ____________          ____
 *          /            \   or   /    \   or, when short,  /\
 *         /              \      /      \                  /  \
 * </pre>
 *
 * The unit of distance is metres or radians.
 *
 * @param top maximum speed
 */
public record Trapezoid(double top, double acceleration, double deceleration) {
    public static final Trapezoid FORWARD =
            new Trapezoid(Pioneer2Dx.TOP_SPEED_METERS_PER_SECOND, Pioneer2Dx.ACCELERATION_METERS_PER_SECOND2);
    public static final Trapezoid TURN =
            new Trapezoid(Pioneer2Dx.TOP_TURN_RADIANS_PER_SECOND, Pioneer2Dx.TURN_ACCELERATION_RADIANS_PER_SECOND2);

    /** Deceleration beyond the limit that rounding may require to stop at the goal; with more, the goal is overrun. */
    private static final double LANDING_TOLERANCE = 1.001;

    public Trapezoid {
        if (!(top > 0 && acceleration > 0 && deceleration > 0)) {
            throw new IllegalArgumentException("top speed " + top + ", acceleration " + acceleration
                    + " and deceleration " + deceleration + ", expected all above 0");
        }
    }

    /** The same limit for acceleration and deceleration. */
    public Trapezoid(double top, double acceleration) {
        this(top, acceleration, acceleration);
    }

    /** The distance covered in a step of time, and the speed at its end. */
    public record Step(double distance, double speed) {}

    /** Duration from rest to rest over this distance, in seconds. */
    public double seconds(double distance) {
        double slope = (1 / acceleration + 1 / deceleration) / 2;
        double ramps = top * top * slope;
        return distance < ramps ? 2 * Math.sqrt(distance * slope) : distance / top + top * slope;
    }

    /**
     * The next step towards a goal.
     *
     * @param remaining distance to the goal; brakes if it is 0 or less
     * @param speed at the beginning, 0 or more; above the top speed it is first reduced to it
     * @param dt duration of the step in seconds
     */
    public Step towards(double remaining, double speed, double dt) {
        double needed = remaining > 0 ? speed * speed / (2 * remaining) : Double.POSITIVE_INFINITY;
        if (speed > 0 && needed >= deceleration / LANDING_TOLERANCE) {
            return needed <= deceleration * LANDING_TOLERANCE ? land(remaining, speed, needed, dt) : brake(speed, dt);
        }
        if (remaining <= 0) {
            return new Step(0, 0);
        }
        if (speed > top) {
            return slowToTop(remaining, speed, dt);
        }
        double peak = Math.min(top, peak(remaining, speed));
        double rampUp = Math.max(0, (peak - speed) / acceleration);
        if (dt <= rampUp) {
            return new Step((speed + acceleration * dt / 2) * dt, speed + acceleration * dt);
        }
        double upDistance = (speed + peak) / 2 * rampUp;
        double downDistance = peak * peak / (2 * deceleration);
        double cruise = Math.max(0, (remaining - upDistance - downDistance) / peak);
        if (dt <= rampUp + cruise) {
            return new Step(upDistance + peak * (dt - rampUp), peak);
        }
        double before = upDistance + peak * cruise;
        Step down = land(remaining - before, peak, deceleration, dt - rampUp - cruise);
        return down.speed() == 0 ? new Step(remaining, 0) : new Step(before + down.distance(), down.speed());
    }

    /** The speed at which acceleration must end to stop at the goal. */
    private double peak(double remaining, double speed) {
        return acceleration == deceleration
                ? Math.sqrt(acceleration * remaining + speed * speed / 2)
                : Math.sqrt((2 * remaining + speed * speed / acceleration) / (1 / acceleration + 1 / deceleration));
    }

    private Step slowToTop(double remaining, double speed, double dt) {
        double seconds = (speed - top) / deceleration;
        if (dt <= seconds) {
            return new Step((speed - deceleration * dt / 2) * dt, speed - deceleration * dt);
        }
        double distance = (speed + top) / 2 * seconds;
        Step rest = towards(remaining - distance, top, dt - seconds);
        return new Step(distance + rest.distance(), rest.speed());
    }

    /** Decelerates at the limit. */
    public Step brake(double speed, double dt) {
        double seconds = speed / deceleration;
        return dt >= seconds
                ? new Step(speed * seconds / 2, 0)
                : new Step((speed - deceleration * dt / 2) * dt, speed - deceleration * dt);
    }

    private static Step land(double remaining, double speed, double deceleration, double dt) {
        // durations below a nanosecond are rounding error
        return dt >= speed / deceleration - 1e-9
                ? new Step(remaining, 0)
                : new Step((speed - deceleration * dt / 2) * dt, speed - deceleration * dt);
    }
}
