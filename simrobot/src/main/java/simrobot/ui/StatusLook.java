package simrobot.ui;

import simgsm.ui.Mark;
import simgsm.ui.Theme.Ink;
import vericommand.RobotStatus;

/** The shape and the colour of each status. */
public final class StatusLook {
    private StatusLook() {}

    public static Mark mark(RobotStatus status) {
        return switch (status) {
            case STOPPED -> Mark.SQUARE;
            case MOVING -> Mark.ARROW;
            case COLLISION -> Mark.BURST;
            case NO_MOTORS -> Mark.RING;
            case DISCONNECTED -> Mark.SLASHED_RING;
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
