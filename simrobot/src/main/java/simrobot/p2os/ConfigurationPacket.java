package simrobot.p2os;

import simrobot.robot.Drive;

/** The answer to CONFIG (0x20): what the robot is and the limits that it starts with. */
final class ConfigurationPacket {
    private static final int ID = 0x20;

    /** ARIA looks for no serial devices on a robot with this number. */
    private static final String SIMULATED = "SIM";

    private static final String FIRMWARE = "2.9";
    private static final int LOW_BATTERY_DECIVOLTS = 110;
    private static final int REVOLUTION_COUNT = 16570;
    private static final int WATCHDOG_MILLIS = 2000;

    /** Units of 10 ms in which a stall is noticed. */
    private static final int STALL_COUNT = 50;

    private static final int STALL_VALUE = 200;
    private static final int BUMPERS = 5;

    private ConfigurationPacket() {}

    static byte[] of(String name) {
        int topSpeed = (int) Math.round(Drive.AHEAD_LIMITS.top() * 1000);
        int acceleration = (int) Math.round(Drive.AHEAD_LIMITS.acceleration() * 1000);
        int topTurn = (int) Math.round(Math.toDegrees(Drive.TURN_LIMITS.top()));
        int turnAcceleration = (int) Math.round(Math.toDegrees(Drive.TURN_LIMITS.acceleration()));
        P2osFieldWriter octets = new P2osFieldWriter()
                .int1(ID)
                .text(P3dxScale.CLASS)
                .text(P3dxScale.SUBCLASS)
                .text(SIMULATED);
        octets.int1(0)
                .int2s(P3dxScale.MOST_DEGREES_PER_SECOND, P3dxScale.MOST_MILLIMETERS_PER_SECOND)
                .int2s(P3dxScale.MOST_DEGREES_PER_SECOND, P3dxScale.MOST_MILLIMETERS_PER_SECOND)
                // motor power, name, information packets every 100 ms, both baud rates, no gripper
                .int2(500)
                .text(name)
                .int1(P2osSession.SIP_MILLIS)
                .int1(0)
                .int1(0)
                .int2(0)
                // front and rear sonars
                .int2(1)
                .int1(1)
                .int2s(LOW_BATTERY_DECIVOLTS, REVOLUTION_COUNT, WATCHDOG_MILLIS)
                .int1(0)
                .int2s(STALL_VALUE, STALL_COUNT)
                // joystick
                .int2s(topSpeed, topTurn)
                .int2s(topTurn, topSpeed, turnAcceleration, turnAcceleration, 40, 20, 0)
                .int2s(acceleration, acceleration, 40, 30, 0)
                .int1(BUMPERS)
                .int1(BUMPERS)
                // no charger; a sonar every 40 ms; no automatic baud rate, no gyro, no drift
                .int1(0)
                .int1(40)
                .int1(0)
                .int1(0)
                .int2(0)
                .int1(0)
                .int1(0)
                .int2(P3dxScale.TICKS_PER_MILLIMETER)
                .int2(0)
                .text(FIRMWARE)
                // gyro scales, kinematics delay, nothing sideways, no charging threshold
                .int2s(0, 0)
                .int1(0)
                .int2s(0, 0, 0, 0, 0)
                .int2(0);
        return P2osPacket.of(octets.toBytes());
    }
}
