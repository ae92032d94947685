package simrobot.robot;

import simrobot.behaviour.Senses;
import vericommand.RobotStatus;

/** The senses of a process, and the time since it began. */
public abstract class ProcessSenses implements Senses {
    private long nanos;

    protected ProcessSenses() {}

    void elapse(long passedNanos) {
        nanos += passedNanos;
    }

    @Override
    public final double seconds() {
        return nanos * 1e-9;
    }

    protected abstract RobotStatus status();

    protected abstract Bumpers bumpers();

    @Override
    public final boolean isBlocked() {
        return status() == RobotStatus.COLLISION;
    }

    @Override
    public final boolean isFrontBumperPressed(int bumper) {
        return isPressed(bumpers().front(), bumper);
    }

    @Override
    public final boolean isRearBumperPressed(int bumper) {
        return isPressed(bumpers().rear(), bumper);
    }

    private static boolean isPressed(int bits, int bumper) {
        if (bumper < 0 || bumper >= Bumpers.COUNT_EACH) {
            throw new IndexOutOfBoundsException("bumper " + bumper + ", expected 0 to " + (Bumpers.COUNT_EACH - 1));
        }
        return (bits >> bumper & 1) != 0;
    }
}
