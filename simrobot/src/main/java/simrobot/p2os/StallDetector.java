package simrobot.p2os;

import simrobot.robot.Bumpers;
import simrobot.robot.SimulatedRobot;
import vericommand.RobotStatus;

/** Detects stalled wheels after a collision. */
final class StallDetector {
    /** Time until the controller detects a stall by motor current, without a bumper that stalls the wheels. */
    private static final long STALL_NANOS = 500_000_000;

    private final SimulatedRobot robot;
    private boolean frontStalls = true;
    private boolean rearStalls = true;
    private boolean collided;
    private long collidedNanos;

    StallDetector(SimulatedRobot robot) {
        this.robot = robot;
    }

    /** Selects the bumpers that stall the wheels at once. */
    void setBumpers(boolean front, boolean rear) {
        frontStalls = front;
        rearStalls = rear;
    }

    /** @param simulatedNanos the current simulated time */
    void watch(long simulatedNanos) {
        boolean now = robot.status() == RobotStatus.COLLISION;
        if (now && !collided) {
            collidedNanos = simulatedNanos;
        }
        collided = now;
    }

    boolean isNoticed(Bumpers pressed, long simulatedNanos) {
        if (!collided) {
            return false;
        }
        boolean atOnce = (frontStalls && pressed.front() != 0) || (rearStalls && pressed.rear() != 0);
        return atOnce || simulatedNanos - collidedNanos >= STALL_NANOS;
    }
}
