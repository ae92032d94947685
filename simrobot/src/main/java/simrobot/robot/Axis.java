package simrobot.robot;

/**
 * One of the drive's two motions, translation or rotation, towards a speed or a goal within its limits. Distances and
 * speeds are signed, unlike those of {@link Trapezoid}.
 *
 * <p>The unit of distance is metres, or radians anticlockwise.
 */
final class Axis {
    /** A remaining distance below this is rounding error. */
    private static final double REACHED = 1e-12;

    private Trapezoid limits;
    private double speed;
    private double wanted;
    private boolean toGoal;
    private double remaining;

    Axis(Trapezoid limits) {
        this.limits = limits;
    }

    Trapezoid limits() {
        return limits;
    }

    void setLimits(Trapezoid next) {
        limits = next;
    }

    double speed() {
        return speed;
    }

    /** Sets the target speed, limited to the top speed. */
    void setSpeed(double target) {
        wanted = target;
        toGoal = false;
    }

    /**
     * Sets the goal of a motion that ends at rest.
     *
     * @param distance from here
     */
    void setGoal(double distance) {
        remaining = distance;
        toGoal = true;
        wanted = 0;
    }

    /** The distance to the goal; 0 without one. */
    double remaining() {
        return toGoal ? remaining : 0;
    }

    /** The direction of the target: -1, 0 or 1. */
    double direction() {
        return Math.signum(toGoal ? remaining : wanted);
    }

    /** Clears the target and stops at once. */
    void halt() {
        setSpeed(0);
        speed = 0;
    }

    /** The next step of time. */
    Trapezoid.Step next(double seconds) {
        Trapezoid.Step step = toGoal ? towardsGoal(seconds) : towardsSpeed(wanted, seconds);
        return take(step);
    }

    /** A step of slowing down; the target is kept. */
    Trapezoid.Step brake(double seconds) {
        return take(towardsSpeed(0, seconds));
    }

    private Trapezoid.Step take(Trapezoid.Step step) {
        speed = step.speed();
        if (toGoal) {
            remaining -= step.distance();
            if (speed == 0 && Math.abs(remaining) <= REACHED) {
                setSpeed(0);
            }
        }
        return step;
    }

    private Trapezoid.Step towardsGoal(double seconds) {
        double sign = remaining < 0 ? -1 : 1;
        double forth = speed * sign;
        if (forth >= 0) {
            Trapezoid.Step step = limits.towards(remaining * sign, forth, seconds);
            return new Trapezoid.Step(step.distance() * sign, step.speed() * sign + 0.0);
        }
        // it still moves in the opposite direction: decelerate first
        double toRest = -forth / limits.deceleration();
        if (seconds <= toRest) {
            return towardsSpeed(0, seconds);
        }
        double back = speed * toRest / 2;
        Trapezoid.Step step = limits.towards((remaining - back) * sign, 0, seconds - toRest);
        return new Trapezoid.Step(back + step.distance() * sign, step.speed() * sign + 0.0);
    }

    private Trapezoid.Step towardsSpeed(double target, double seconds) {
        double goal = Math.max(-limits.top(), Math.min(limits.top(), target));
        double distance = 0;
        double now = speed;
        double left = seconds;
        while (now != goal) {
            boolean slows = now != 0 && (now * goal < 0 || Math.abs(goal) < Math.abs(now));
            double milestone = now * goal < 0 ? 0 : goal;
            double rate = Math.copySign(slows ? limits.deceleration() : limits.acceleration(), milestone - now);
            double needed = (milestone - now) / rate;
            if (needed >= left) {
                double end = now + rate * left;
                return new Trapezoid.Step(distance + (now + end) / 2 * left, needed == left ? milestone : end);
            }
            distance += (now + milestone) / 2 * needed;
            now = milestone;
            left -= needed;
        }
        return new Trapezoid.Step(distance + goal * left, goal + 0.0);
    }
}
