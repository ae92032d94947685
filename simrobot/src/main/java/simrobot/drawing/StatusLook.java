package simrobot.drawing;

import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import vericommand.RobotStatus;

/** The shape and colour of each status. */
public final class StatusLook {
    private StatusLook() {}

    public static StatusMark mark(RobotStatus status) {
        return switch (status) {
            case STOPPED -> StatusMark.SQUARE;
            case MOVING -> StatusMark.ARROW;
            case COLLISION -> StatusMark.BURST;
            case NO_MOTORS -> StatusMark.RING;
            case DISCONNECTED -> StatusMark.SLASHED_RING;
        };
    }

    public static Ink ink(RobotStatus status) {
        return switch (status) {
            case STOPPED -> Ink.GOOD;
            case MOVING -> Ink.ACCENT;
            case COLLISION -> Ink.DANGER;
            case NO_MOTORS -> Ink.WARNING;
            case DISCONNECTED -> Ink.QUIET;
        };
    }
}
