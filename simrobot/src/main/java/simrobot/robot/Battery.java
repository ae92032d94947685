package simrobot.robot;

/**
 * Three lead batteries of 12 V and 7.2 Ah, as in the 2-DX. Full whenever the robot is switched on; empty ones still
 * drive the robot, so that a lesson can continue.
 */
public final class Battery {
    public static final double FULL_VOLTS = 12.7;

    /** Low-battery threshold, as in the configuration packet. */
    public static final double LOW_VOLTS = 11;

    /** The lowest reported voltage. */
    private static final double EMPTY_VOLTS = 10.5;

    private static final double CAPACITY_JOULES = 3 * 12 * 7.2 * 3600;

    /** Power of controller, sonars, modem and camera: lasts about 11 h at rest. */
    private static final double STANDING_WATTS = 24;

    /** Power of the motors: at top speed 1.5 times the power at rest. */
    private static final double WATTS_PER_METER_PER_SECOND = 72;

    private static final double WATTS_PER_RADIAN_PER_SECOND = 18;

    private double volts = FULL_VOLTS;

    Battery() {}

    /** Draws power for a duration at these speeds. */
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

    /** Sets the voltage, for a client that tests its alarms; it decreases from there. */
    public void setVolts(double newVolts) {
        volts = newVolts;
    }

    public double volts() {
        return volts;
    }

    /** 1 if full, 0 if empty. */
    public double chargeShare() {
        return chargeShare(volts);
    }

    /** The charge share at a voltage. */
    public static double chargeShare(double volts) {
        return Math.max(0, Math.min(1, (volts - EMPTY_VOLTS) / (FULL_VOLTS - EMPTY_VOLTS)));
    }

    public boolean isLow() {
        return volts < LOW_VOLTS;
    }
}
