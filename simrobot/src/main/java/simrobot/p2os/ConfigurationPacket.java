package simrobot.p2os;

import simgsm.octets.OctetWriter;
import simrobot.robot.Drive;

/** The answer to CONFIG (0x20): the robot's type, equipment and initial limits. */
final class ConfigurationPacket {
    private static final int ID = 0x20;

    /** Serial number that makes ARIA look for no serial devices. */
    private static final String SIMULATED = "SIM";

    private static final String FIRMWARE = "2.9";
    private static final int LOW_BATTERY_DECIVOLTS = 110;
    private static final int REVOLUTION_COUNT = 16570;
    private static final int WATCHDOG_MILLIS = 2000;

    /** Time until a stall is detected, in units of 10 ms. */
    private static final int STALL_COUNT = 50;

    private static final int STALL_VALUE = 200;
    private static final int BUMPERS = 5;

    private ConfigurationPacket() {}

    static byte[] of(String name) {
        int topSpeed = (int) Math.round(Drive.AHEAD_LIMITS.top() * 1000);
        int acceleration = (int) Math.round(Drive.AHEAD_LIMITS.acceleration() * 1000);
        int topTurn = (int) Math.round(Math.toDegrees(Drive.TURN_LIMITS.top()));
        int turnAcceleration = (int) Math.round(Math.toDegrees(Drive.TURN_LIMITS.acceleration()));
        OctetWriter octets = P2osPacket.data()
                .octet(ID)
                .zeroEnded(P3dxScale.CLASS)
                .zeroEnded(P3dxScale.SUBCLASS)
                .zeroEnded(SIMULATED);
        octets.octet(0)
                .twoOctets(P3dxScale.MOST_DEGREES_PER_SECOND, P3dxScale.MOST_MILLIMETERS_PER_SECOND)
                .twoOctets(P3dxScale.MOST_DEGREES_PER_SECOND, P3dxScale.MOST_MILLIMETERS_PER_SECOND)
                // motor power, name, information packets every 100 ms, both baud rates, no gripper
                .twoOctets(500)
                .zeroEnded(name)
                .bytes(new byte[] {P2osSession.SIP_MILLIS, 0, 0})
                .twoOctets(0)
                // front and rear sonars
                .twoOctets(1)
                .octet(1)
                .twoOctets(LOW_BATTERY_DECIVOLTS, REVOLUTION_COUNT, WATCHDOG_MILLIS)
                .octet(0)
                .twoOctets(STALL_VALUE, STALL_COUNT)
                // joystick
                .twoOctets(topSpeed, topTurn)
                .twoOctets(topTurn, topSpeed, turnAcceleration, turnAcceleration, 40, 20, 0)
                .twoOctets(acceleration, acceleration, 40, 30, 0)
                .bytes(new byte[] {BUMPERS, BUMPERS})
                // no charger; a sonar every 40 ms; no automatic baud rate, no gyro, no drift
                .bytes(new byte[] {0, 40, 0, 0, 0, 0, 0, 0})
                .twoOctets(P3dxScale.TICKS_PER_MILLIMETER)
                .twoOctets(0)
                .zeroEnded(FIRMWARE)
                // gyro scales, kinematics delay, no lateral motion, no charging threshold
                .twoOctets(0, 0)
                .octet(0)
                .twoOctets(0, 0, 0, 0, 0)
                .twoOctets(0);
        return P2osPacket.of(octets.toArray());
    }
}
