package simrobot.p2os;

import java.util.ArrayList;
import java.util.List;
import simgsm.octets.OctetWriter;
import simrobot.robot.LaserField;
import simrobot.robot.SimulatedRobot;

/**
 * The laser that a client has switched on: its field, and its packets, at most 32 readings each. Octets per field:
 *
 * <pre>
 *   0x60 1 | x 2 | y 2 | heading 2 | readings in all 2 | first 2 | count 1 | count times: range 2
 *   0x61 1 | readings in all 2 | first 2 | count 1 | count times: range 2, reflectance 1, 0 1, 0 1 | laser 1 | flags 1
 * </pre>
 *
 * Ranges in mm; position in mm and heading in degrees by the odometry.
 */
final class LaserReports {
    private static final int PLAIN_ID = 0x60;
    private static final int EXTENDED_ID = 0x61;
    private static final int EXTENDED_MODE = 2;
    private static final int MOST_READINGS = 32;

    private final SimulatedRobot robot;
    private int mode;
    private double startDegrees = LaserField.USUAL.startDegrees();
    private double endDegrees = LaserField.USUAL.endDegrees();
    private double stepDegrees = LaserField.USUAL.stepDegrees();

    LaserReports(SimulatedRobot robot) {
        this.robot = robot;
    }

    /** Sets the packets to send: 0 none, 1 plain, 2 extended. */
    void setMode(int newMode) {
        mode = newMode;
        robot.laser().setOn(mode != 0);
    }

    /** Sets the direction of the first reading. Nothing is sent while the field is invalid. */
    void setStart(int degrees) {
        startDegrees = degrees;
    }

    /** Sets the direction of the last reading. */
    void setEnd(int degrees) {
        endDegrees = degrees;
    }

    /** Sets the angle between readings. */
    void setStep(int hundredthsOfDegree) {
        stepDegrees = hundredthsOfDegree / 100.0;
    }

    /** Handles the client's end. */
    void end() {
        setMode(0);
    }

    /** The packets of one scan; none while the laser is off. */
    List<byte[]> scan() {
        LaserField field = mode == 0 ? null : field();
        if (field == null) {
            return List.of();
        }
        double[] ranges = robot.laser().rangesMeters(field);
        List<byte[]> packets = new ArrayList<>();
        for (int first = 0; first < ranges.length; first += MOST_READINGS) {
            packets.add(packet(ranges, first, Math.min(MOST_READINGS, ranges.length - first)));
        }
        return packets;
    }

    private LaserField field() {
        try {
            return new LaserField(startDegrees, endDegrees, stepDegrees);
        } catch (IllegalArgumentException noField) {
            return null;
        }
    }

    private byte[] packet(double[] ranges, int first, int count) {
        boolean extended = mode == EXTENDED_MODE;
        OctetWriter data = P2osPacket.data().octet(extended ? EXTENDED_ID : PLAIN_ID);
        if (!extended) {
            data.twoOctets(P3dxScale.millimeters(robot.odometry().xMeters()))
                    .twoOctets(P3dxScale.millimeters(robot.odometry().yMeters()))
                    .twoOctets((int) Math.round(Math.toDegrees(robot.odometry().headingRadians())));
        }
        data.twoOctets(ranges.length, first).octet(count);
        for (int i = first; i < first + count; i++) {
            data.twoOctets(P3dxScale.millimeters(ranges[i]));
            if (extended) {
                data.octet(0).octet(0).octet(0);
            }
        }
        if (extended) {
            data.octet(0).octet(0);
        }
        return P2osPacket.of(data.toArray());
    }
}
