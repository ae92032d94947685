package simrobot.p2os;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import java.util.TreeMap;

/** An information packet as a client reads it. */
record Sip(
        int id,
        int x,
        int y,
        int heading,
        int left,
        int right,
        int battery,
        int leftByte,
        int rightByte,
        int target,
        int flags,
        Map<Integer, Integer> sonars,
        int turn) {
    static Sip of(byte[] data) {
        ByteBuffer in = ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
        int id = in.get() & 0xFF;
        int x = in.getShort() & 0xFFFF;
        int y = in.getShort() & 0xFFFF;
        int heading = in.getShort();
        int left = in.getShort();
        int right = in.getShort();
        int battery = in.get() & 0xFF;
        int leftByte = in.get() & 0xFF;
        int rightByte = in.get() & 0xFF;
        int target = in.getShort();
        int flags = in.getShort() & 0xFFFF;
        in.get();
        Map<Integer, Integer> sonars = new TreeMap<>();
        for (int n = in.get(); n > 0; n--) {
            sonars.put((int) in.get(), in.getShort() & 0xFFFF);
        }
        in.position(in.position() + 5 + 2 + 1);
        int turn = in.getShort();
        return new Sip(id, x, y, heading, left, right, battery, leftByte, rightByte, target, flags, sonars, turn);
    }

    double xMillimeters() {
        return x * P3dxScale.MILLIMETERS_PER_UNIT;
    }

    double headingDegrees() {
        return heading * 360.0 / P3dxScale.UNITS_PER_TURN;
    }

    boolean stalled() {
        return (leftByte & 1) != 0 && (rightByte & 1) != 0;
    }

    boolean motors() {
        return (flags & 1) != 0;
    }
}
