package simrobot.drawing;

import simgsm.draw.Ink;

/**
 * A place where a robot is to be put, or was refused.
 *
 * @param text below it; may be empty
 * @param refused drawn crossed out and in the colour of danger
 */
public record RobotPreview(double xMeters, double yMeters, double headingRadians, String text, boolean refused) {
    Ink ink() {
        return refused ? Ink.DANGER : Ink.ACCENT;
    }
}
