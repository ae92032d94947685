package simrobot.robot;

/**
 * The robot driven directly, as a Pioneer's own controller offers it: speeds or goals for the way and for the turn, each
 * within limits that the client may set. Goals count by the wheels, so they are exact as far as the wheels grip.
 *
 * <p>Belongs to the robot, which steps it; targets are forgotten when the motors go off and when something is touched.
 * Metres, radians anticlockwise, seconds.
 */
public final class Drive {
    /** Limits that a client finds at first: top speeds that the 3-DX reaches, the configuration packet's accelerations. */
    public static final Trapezoid AHEAD_LIMITS = new Trapezoid(1.0, Pioneer2Dx.ACCELERATION_METERS_PER_SECOND2);

    public static final Trapezoid TURN_LIMITS =
            new Trapezoid(Math.toRadians(150), Pioneer2Dx.TURN_ACCELERATION_RADIANS_PER_SECOND2);

    private final Axis ahead = new Axis(AHEAD_LIMITS);
    private final Axis turn = new Axis(TURN_LIMITS);
    private boolean suspended;

    Drive() {}

    public Trapezoid aheadLimits() {
        return ahead.limits();
    }

    public Trapezoid turnLimits() {
        return turn.limits();
    }

    /** Limits hold from now on, for the motion under way too. */
    public void setLimits(Trapezoid aheadLimits, Trapezoid turnLimits) {
        ahead.setLimits(aheadLimits);
        turn.setLimits(turnLimits);
    }

    /** Goes ahead at this speed, negative back. */
    public void setSpeed(double metersPerSecond) {
        ahead.setSpeed(metersPerSecond);
    }

    /** Turns at this speed. */
    public void setTurnSpeed(double radiansPerSecond) {
        turn.setSpeed(radiansPerSecond);
    }

    /** Goes so far from here, negative back, and stands. */
    public void move(double meters) {
        ahead.setWay(meters);
    }

    /** Turns so far from here and stands. */
    public void turn(double radians) {
        turn.setWay(radians);
    }

    /** What is left of a turn to a goal; 0 without one. */
    public double remainingTurn() {
        return turn.remaining();
    }

    /** Slows to a stand with the set deceleration and forgets all targets. */
    public void stop() {
        ahead.setSpeed(0);
        turn.setSpeed(0);
        suspended = false;
    }

    /** True: slows to a stand but keeps the targets; false: goes on towards them. */
    public void setSuspended(boolean suspend) {
        suspended = suspend;
    }

    // ---- for the robot -------------------------------------------------------------------------------------------

    /** Forgets all targets, standing at once. */
    void halt() {
        ahead.halt();
        turn.halt();
        suspended = false;
    }

    /** Whether it moves or wants to. */
    boolean isActive() {
        boolean runs = ahead.speed() != 0 || turn.speed() != 0;
        return runs || (!suspended && (ahead.sense() != 0 || turn.sense() != 0));
    }

    /** Which way it is about to set out from rest: -1 back, 1 ahead, 0 not at all. */
    double setsOut() {
        return ahead.speed() == 0 && !suspended ? ahead.sense() : 0;
    }

    void forgetWay() {
        ahead.halt();
    }

    double speed() {
        return ahead.speed();
    }

    double turnSpeed() {
        return turn.speed();
    }

    Trapezoid.Stretch nextAhead(double seconds) {
        return suspended ? ahead.brake(seconds) : ahead.next(seconds);
    }

    Trapezoid.Stretch nextTurn(double seconds) {
        return suspended ? turn.brake(seconds) : turn.next(seconds);
    }
}
