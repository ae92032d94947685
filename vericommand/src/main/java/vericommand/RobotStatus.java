package vericommand;

import java.util.Locale;

/** The paper's five statuses; consoles, windows and tests use {@link #text()}. */
public enum RobotStatus {
    /** The robot has collided; it can only turn. */
    COLLISION("Collision"),
    /** The robot moves, or brakes. */
    MOVING("Moving"),
    /** Robot and motors on, standing still. */
    STOPPED("Stopped"),
    /** Robot on, motors off. */
    NO_MOTORS("No motors"),
    /** Robot off. */
    DISCONNECTED("Disconnected");

    private final String text;

    RobotStatus(String text) {
        this.text = text;
    }

    public String text() {
        return text;
    }

    /** The status with this name; case, blanks, {@code -} and {@code _} are ignored. */
    public static RobotStatus ofText(String text) {
        for (RobotStatus status : values()) {
            if (plain(status.text).equals(plain(text))) {
                return status;
            }
        }
        throw new IllegalArgumentException(
                "no such status: " + text + "; expected Collision, Moving, Stopped, No motors or Disconnected");
    }

    private static String plain(String text) {
        return text.toLowerCase(Locale.ROOT).replaceAll("[\\s_-]", "");
    }
}
