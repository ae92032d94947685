package simrobot.robot;

/**
 * The motion controller that a Pioneer offers to its clients: target speeds or goals for translation and rotation,
 * within limits set by the client. Goals are measured by the wheels, so they are exact unless the wheels slip.
 *
 * <p>The robot steps it; targets are cleared when the motors are switched off and at a contact. Metres, radians
 * anticlockwise, seconds.
 */
public final class Drive {
    /** Initial limits: top speeds of the 3-DX, accelerations of the configuration packet. */
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

    /** Sets the limits, for the current motion too. */
    public void setLimits(Trapezoid aheadLimits, Trapezoid turnLimits) {
        ahead.setLimits(aheadLimits);
        turn.setLimits(turnLimits);
    }

    /** Sets the target speed ahead, negative back. */
    public void setSpeed(double metersPerSecond) {
        ahead.setSpeed(metersPerSecond);
    }

    /** Sets the target turning speed. */
    public void setTurnSpeed(double radiansPerSecond) {
        turn.setSpeed(radiansPerSecond);
    }

    /** Sets a goal at this distance ahead, negative back. */
    public void move(double meters) {
        ahead.setGoal(meters);
    }

    /** Sets a goal at this angle. */
    public void turn(double radians) {
        turn.setGoal(radians);
    }

    /** The angle to the goal; 0 without one. */
    public double remainingTurn() {
        return turn.remaining();
    }

    /** Decelerates to rest with the set deceleration, and clears all targets. */
    public void stop() {
        ahead.setSpeed(0);
        turn.setSpeed(0);
        suspended = false;
    }

    /** True decelerates to rest but keeps the targets; false resumes them. */
    public void setSuspended(boolean suspend) {
        suspended = suspend;
    }

    // ---- for the robot -------------------------------------------------------------------------------------------

    /** Clears all targets and stops at once. */
    void halt() {
        ahead.halt();
        turn.halt();
        suspended = false;
    }

    /** True if it moves or has a target. */
    boolean isActive() {
        boolean moves = ahead.speed() != 0 || turn.speed() != 0;
        return moves || (!suspended && (ahead.direction() != 0 || turn.direction() != 0));
    }

    /** The direction of a start from rest: -1 back, 1 ahead, 0 none. */
    double startDirection() {
        return ahead.speed() == 0 && !suspended ? ahead.direction() : 0;
    }

    void haltAhead() {
        ahead.halt();
    }

    double speed() {
        return ahead.speed();
    }

    double turnSpeed() {
        return turn.speed();
    }

    Trapezoid.Step nextAhead(double seconds) {
        return suspended ? ahead.brake(seconds) : ahead.next(seconds);
    }

    Trapezoid.Step nextTurn(double seconds) {
        return suspended ? turn.brake(seconds) : turn.next(seconds);
    }
}
