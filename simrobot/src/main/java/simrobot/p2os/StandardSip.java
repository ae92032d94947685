package simrobot.p2os;

import simgsm.octets.OctetWriter;

/**
 * The server information packet, 0x32 for a robot that stands and 0x33 for one that moves.
 *
 * <pre>
 *   id 1 | x 2 | y 2 | heading 2 | left 2 | right 2 | battery 1 | left stall, rear bumpers 1 | right stall, front bumpers 1
 *   | heading target 2 | flags 2 | compass 1 | n 1 | n times: sonar 1, range 2 | gripper 1 | analogue port 1 | analogue 1
 *   | digital in 1 | digital out 1 | battery 2 | charger 1 | turn 2 | faults 2 | lateral 2 | temperature 1 | charge 1
 * </pre>
 *
 * @param x with y in distance units, 15 bits
 * @param heading with target in angle units, signed
 * @param left with right the wheels' speeds, mm/s
 * @param frontBumpers five bits, the leftmost bumper lowest
 * @param rearBumpers five bits, clockwise on, so the rightmost lowest
 * @param sonars which discs have heard something
 * @param rangesMillimeters what they heard, in the order of sonars
 * @param turnDecidegreesPerSecond anticlockwise
 */
record StandardSip(
        boolean moving,
        int x,
        int y,
        int heading,
        int left,
        int right,
        int batteryDecivolts,
        int chargePercent,
        boolean stalled,
        int frontBumpers,
        int rearBumpers,
        int target,
        boolean motors,
        boolean sonarOn,
        int[] sonars,
        int[] rangesMillimeters,
        int turnDecidegreesPerSecond) {
    static final int STOPPED_ID = 0x32;
    static final int MOVING_ID = 0x33;
    static final int SONARS = 16;

    private static final int MOTORS_FLAG = 1;

    /** All four sonar arrays. */
    private static final int SONAR_FLAGS = 0b11110;

    /** Inputs that nothing pulls down. */
    private static final int OPEN_INPUTS = 0xFF;

    private static final int NO_THERMOMETER = -127;

    byte[] packet() {
        OctetWriter octets = P2osPacket.data()
                .octet(moving ? MOVING_ID : STOPPED_ID)
                .twoOctets(x, y, heading, left, right)
                .octet(batteryDecivolts)
                .octet(rearBumpers << 1 | (stalled ? 1 : 0))
                .octet(frontBumpers << 1 | (stalled ? 1 : 0))
                .twoOctets(target)
                .twoOctets((motors ? MOTORS_FLAG : 0) | (sonarOn ? SONAR_FLAGS : 0))
                .octet(0)
                .octet(sonars.length);
        for (int i = 0; i < sonars.length; i++) {
            octets.octet(sonars[i]).twoOctets(rangesMillimeters[i]);
        }
        octets.octet(0).octet(0).octet(0).octet(OPEN_INPUTS).octet(0);
        octets.twoOctets(batteryDecivolts).octet(0).twoOctets(turnDecidegreesPerSecond, 0, 0);
        return P2osPacket.of(octets.octet(NO_THERMOMETER).octet(chargePercent).toArray());
    }
}
