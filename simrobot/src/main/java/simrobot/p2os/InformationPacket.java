package simrobot.p2os;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simrobot.robot.Bumpers;

/**
 * The server information packet (SIP): id 0x32 of a robot at rest, 0x33 of a moving one. Octets per field; numbers are
 * little-endian.
 *
 * <pre>
 *   id 1 | x 2 | y 2 | heading 2 | left 2 | right 2 | battery 1 | left stall, rear bumpers 1 | right stall, front bumpers 1
 *   | heading target 2 | flags 2 | compass 1 | n 1 | n times: sonar 1, range 2 | gripper 1 | analogue port 1 | analogue 1
 *   | digital in 1 | digital out 1 | battery 2 | charger 1 | turn 2 | faults 2 | lateral 2 | temperature 1 | charge 1
 * </pre>
 *
 * {@link P2osReports} writes it; this record holds the fields that a client reads, in the robot's own units.
 *
 * @param movingId true if the id is 0x33
 * @param x with y in distance units, 15 bits, wrapping
 * @param heading 4096 units per turn, anticlockwise
 * @param leftWheel with rightWheel mm/s
 * @param frontBumpers five bits, the leftmost bumper lowest
 * @param rearBumpers five bits, clockwise on, so the rightmost lowest
 * @param echoes ranges measured since the last packet
 */
public record InformationPacket(
        boolean movingId,
        int x,
        int y,
        int heading,
        int leftWheel,
        int rightWheel,
        int batteryDecivolts,
        boolean stalled,
        int frontBumpers,
        int rearBumpers,
        boolean motors,
        List<Echo> echoes) {
    /** One sonar's range, in the robot's range units. */
    public record Echo(int sonar, int range) {}

    static final int STOPPED_ID = 0x32;
    static final int MOVING_ID = 0x33;
    static final int MOTORS_FLAG = 1;

    /** Flags of all four sonar arrays. */
    static final int SONAR_FLAGS = 0b11110;

    private static final int HEAD_LENGTH = 20;
    private static final int ECHO_LENGTH = 3;

    /**
     * True if the packet's id is that of an information packet.
     *
     * @param data data of a packet, without its frame
     */
    public static boolean isOne(byte[] data) {
        int id = data[0] & 0xFF;
        return id == STOPPED_ID || id == MOVING_ID;
    }

    /**
     * Decodes the packet; empty if it is of another kind or too short. @param data data of a packet, without its frame
     */
    public static Optional<InformationPacket> read(byte[] data) {
        if (!isOne(data) || data.length < HEAD_LENGTH) {
            return Optional.empty();
        }
        List<Echo> echoes = new ArrayList<>();
        int count = data[HEAD_LENGTH - 1] & 0xFF;
        for (int i = 0; i < count && HEAD_LENGTH + (i + 1) * ECHO_LENGTH <= data.length; i++) {
            int at = HEAD_LENGTH + i * ECHO_LENGTH;
            echoes.add(new Echo(data[at] & 0xFF, unsigned(data, at + 1)));
        }
        return Optional.of(new InformationPacket(
                (data[0] & 0xFF) == MOVING_ID,
                unsigned(data, 1),
                unsigned(data, 3),
                (short) unsigned(data, 5),
                (short) unsigned(data, 7),
                (short) unsigned(data, 9),
                data[11] & 0xFF,
                ((data[12] | data[13]) & 1) != 0,
                data[13] >> 1 & 0x1F,
                data[12] >> 1 & 0x1F,
                (data[16] & MOTORS_FLAG) != 0,
                List.copyOf(echoes)));
    }

    /** The pressed bumpers as bits, the front ones lowest. */
    public int bumpers() {
        return frontBumpers | rearBumpers << Bumpers.COUNT_EACH;
    }

    private static int unsigned(byte[] data, int at) {
        return data[at] & 0xFF | (data[at + 1] & 0xFF) << 8;
    }

    /** True if the robot moves. MobileSim always sends the id of a robot at rest, so the wheel speeds count too. */
    public boolean isMoving() {
        return movingId || leftWheel != 0 || rightWheel != 0;
    }
}
