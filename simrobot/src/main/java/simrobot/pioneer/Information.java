package simrobot.pioneer;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A robot's information packet (SIP), in its own units.
 *
 * @param x with y 15 bits, rolling over
 * @param heading 4096 to the turn, anticlockwise
 * @param leftWheel with rightWheel mm/s
 * @param echoes what sonars have heard since the last one
 */
record Information(
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
    record Echo(int sonar, int range) {}

    private static final int STOPPED_ID = 0x32;
    private static final int MOVING_ID = 0x33;
    private static final int HEAD_LENGTH = 20;
    private static final int ECHO_LENGTH = 3;
    private static final int MOTORS_FLAG = 1;

    static boolean isOne(byte[] data) {
        int id = data[0] & 0xFF;
        return id == STOPPED_ID || id == MOVING_ID;
    }

    /** @param data of a packet, without its frame; empty when it is none or too short */
    static Optional<Information> read(byte[] data) {
        if (!isOne(data) || data.length < HEAD_LENGTH) {
            return Optional.empty();
        }
        List<Echo> echoes = new ArrayList<>();
        int count = data[HEAD_LENGTH - 1] & 0xFF;
        for (int i = 0; i < count && HEAD_LENGTH + (i + 1) * ECHO_LENGTH <= data.length; i++) {
            int at = HEAD_LENGTH + i * ECHO_LENGTH;
            echoes.add(new Echo(data[at] & 0xFF, unsigned(data, at + 1)));
        }
        return Optional.of(new Information(
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

    private static int unsigned(byte[] data, int at) {
        return data[at] & 0xFF | (data[at + 1] & 0xFF) << 8;
    }

    /** MobileSim's packets never say so by their id, so the wheels are asked, too. */
    boolean moves() {
        return movingId || leftWheel != 0 || rightWheel != 0;
    }
}
