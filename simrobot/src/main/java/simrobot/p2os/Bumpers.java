package simrobot.p2os;

import java.util.OptionalDouble;
import simrobot.robot.SimulatedRobot;
import vericommand.RobotStatus;

/**
 * What presses on the robot, and whether its wheels have stalled for it. Five bumpers in front and five behind share the
 * round evenly; like the sonars they count clockwise, the front ones from the left, the rear ones from the right.
 */
final class Bumpers {
    private static final int COUNT = 5;

    /** Without a bumper that stalls the wheels, the controller notices by their current only after half a second. */
    private static final long STALL_NANOS = 500_000_000;

    private final SimulatedRobot robot;
    private boolean frontStalls = true;
    private boolean rearStalls = true;
    private boolean collided;
    private long collidedNanos;

    Bumpers(SimulatedRobot robot) {
        this.robot = robot;
    }

    void setStalls(Command.BumpStall sides) {
        frontStalls = sides.front();
        rearStalls = sides.rear();
    }

    /** @param simulatedNanos now */
    void watch(long simulatedNanos) {
        boolean now = robot.status() == RobotStatus.COLLISION;
        if (now && !collided) {
            collidedNanos = simulatedNanos;
        }
        collided = now;
    }

    boolean isStalled(long simulatedNanos) {
        if (!collided) {
            return false;
        }
        boolean atOnce = (frontStalls && front() != 0) || (rearStalls && rear() != 0);
        return atOnce || simulatedNanos - collidedNanos >= STALL_NANOS;
    }

    /** Five bits, the leftmost lowest. */
    int front() {
        return pressed(Math.PI / 2);
    }

    /** Five bits, the rightmost lowest. */
    int rear() {
        return pressed(-Math.PI / 2);
    }

    /** The bumpers of the half turn that begins there and goes on clockwise. */
    private int pressed(double from) {
        OptionalDouble bearing = robot.touchBearingRadians();
        if (bearing.isEmpty()) {
            return 0;
        }
        double clockwise = Math.IEEEremainder(from - Math.PI / 2 - bearing.getAsDouble(), 2 * Math.PI) + Math.PI / 2;
        int bumper = (int) Math.floor(clockwise / Math.PI * COUNT);
        return clockwise >= 0 && bumper < COUNT ? 1 << bumper : 0;
    }
}
