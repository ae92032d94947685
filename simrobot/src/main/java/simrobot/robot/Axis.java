package simrobot.robot;

/**
 * One of the drive's two motions, along or about: towards a speed or towards a goal, within its limits. Signed, unlike
 * the {@link Trapezoid} that it steps along.
 *
 * <p>The unit of way is free: metres, or radians anticlockwise.
 */
final class Axis {
    /** Goals that lie nearer are reached: rounding, not way. */
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

    /** Goes at this speed, or at the top one, until told otherwise. */
    void setSpeed(double target) {
        wanted = target;
        toGoal = false;
    }

    /** Comes to rest so far from here. */
    void setWay(double way) {
        remaining = way;
        toGoal = true;
        wanted = 0;
    }

    /** What is left to a goal; 0 without one. */
    double remaining() {
        return toGoal ? remaining : 0;
    }

    boolean isToGoal() {
        return toGoal;
    }

    /** Which way it wants to go: -1, 0 or 1. */
    double sense() {
        return Math.signum(toGoal ? remaining : wanted);
    }

    /** Forgets its target and stands at once. */
    void halt() {
        setSpeed(0);
        speed = 0;
    }

    /** The wheels' next stretch, signed. */
    Trapezoid.Stretch next(double seconds) {
        Trapezoid.Stretch stretch = toGoal ? towardsGoal(seconds) : towardsSpeed(wanted, seconds);
        return take(stretch);
    }

    /** A stretch of slowing down; the target is kept. */
    Trapezoid.Stretch brake(double seconds) {
        return take(towardsSpeed(0, seconds));
    }

    private Trapezoid.Stretch take(Trapezoid.Stretch stretch) {
        speed = stretch.speed();
        if (toGoal) {
            remaining -= stretch.way();
            if (speed == 0 && Math.abs(remaining) <= REACHED) {
                setSpeed(0);
            }
        }
        return stretch;
    }

    private Trapezoid.Stretch towardsGoal(double seconds) {
        double sense = remaining < 0 ? -1 : 1;
        double forth = speed * sense;
        if (forth >= 0) {
            Trapezoid.Stretch stretch = limits.towards(remaining * sense, forth, seconds);
            return new Trapezoid.Stretch(stretch.way() * sense, stretch.speed() * sense + 0.0);
        }
        // it still runs the other way: first to rest
        double toRest = -forth / limits.deceleration();
        if (seconds <= toRest) {
            return towardsSpeed(0, seconds);
        }
        double back = speed * toRest / 2;
        Trapezoid.Stretch stretch = limits.towards((remaining - back) * sense, 0, seconds - toRest);
        return new Trapezoid.Stretch(back + stretch.way() * sense, stretch.speed() * sense + 0.0);
    }

    private Trapezoid.Stretch towardsSpeed(double target, double seconds) {
        double goal = Math.max(-limits.top(), Math.min(limits.top(), target));
        double way = 0;
        double now = speed;
        double left = seconds;
        while (now != goal) {
            boolean slows = now != 0 && (now * goal < 0 || Math.abs(goal) < Math.abs(now));
            double milestone = now * goal < 0 ? 0 : goal;
            double rate = Math.copySign(slows ? limits.deceleration() : limits.acceleration(), milestone - now);
            double needed = (milestone - now) / rate;
            if (needed >= left) {
                double end = now + rate * left;
                return new Trapezoid.Stretch(way + (now + end) / 2 * left, needed == left ? milestone : end);
            }
            way += (now + milestone) / 2 * needed;
            now = milestone;
            left -= needed;
        }
        return new Trapezoid.Stretch(way + goal * left, goal + 0.0);
    }
}
