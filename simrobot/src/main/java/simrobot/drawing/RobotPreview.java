package simrobot.drawing;

import simgsm.draw.Ink;

/**
 * A place for a robot: where one is to be put, or where it was refused.
 *
 * @param text below it, empty for none
 * @param refused drawn crossed out and in the colour of danger
 */
public record RobotPreview(double xMeters, double yMeters, double headingRadians, String text, boolean refused) {
    Ink ink() {
        return refused ? Ink.DANGER : Ink.ACCENT;
    }
}
