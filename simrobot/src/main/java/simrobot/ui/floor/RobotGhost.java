package simrobot.ui.floor;

import simgsm.draw.Ink;

/**
 * A robot that is not there: where one is to be put, or where one was not let.
 *
 * @param text beneath it, empty for none
 * @param refused crossed out, too: nothing hangs on the colour
 */
public record RobotGhost(double xMeters, double yMeters, double headingRadians, String text, boolean refused) {
    Ink ink() {
        return refused ? Ink.DANGER : Ink.ACCENT;
    }
}
