package simrobot.robot;

/**
 * Three lead batteries of 12 V and 7.2 Ah, as the 2-DX carries them. Full whenever the robot is switched on, as if somebody
 * had changed them; empty they still let the robot crawl on, so that a class is not left with a dead robot.
 */
public final class Battery {
    public static final double FULL_VOLTS = 12.7;

    /** Below it the robot ought to be charged (its configuration packet says so, too). */
    public static final double LOW_VOLTS = 11;

    /** It tells no less. */
    private static final double EMPTY_VOLTS = 10.5;

    private static final double CAPACITY_JOULES = 3 * 12 * 7.2 * 3600;

    /** Controller, sonars, modem and camera: some eleven hours of standing. */
    private static final double STANDING_WATTS = 24;

    /** At top speed the motors take as much again, and half of it. */
    private static final double WATTS_PER_METER_PER_SECOND = 72;

    private static final double WATTS_PER_RADIAN_PER_SECOND = 18;

    private double volts = FULL_VOLTS;

    Battery() {}

    /** A stretch of time at these speeds of the wheels. */
    void drain(double seconds, double metersPerSecond, double radiansPerSecond) {
        double watts = STANDING_WATTS
                + WATTS_PER_METER_PER_SECOND * Math.abs(metersPerSecond)
                + WATTS_PER_RADIAN_PER_SECOND * Math.abs(radiansPerSecond);
        volts = Math.max(
                Math.min(volts, EMPTY_VOLTS), volts - (FULL_VOLTS - EMPTY_VOLTS) * watts * seconds / CAPACITY_JOULES);
    }

    void refill() {
        volts = FULL_VOLTS;
    }

    /** As a client that tests its alarms wants it; it drains on from there. */
    public void setVolts(double newVolts) {
        volts = newVolts;
    }

    public double volts() {
        return volts;
    }

    /** 1 when full, 0 when empty. */
    public double chargeShare() {
        return Math.max(0, Math.min(1, (volts - EMPTY_VOLTS) / (FULL_VOLTS - EMPTY_VOLTS)));
    }

    public boolean isLow() {
        return volts < LOW_VOLTS;
    }
}
