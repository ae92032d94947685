package simrobot.control;

import simgsm.air.Msisdn;

/**
 * A robot's name in consoles and windows, and its modem's number.
 *
 * @param name one word without {@code @} and {@code =}
 */
public record RobotName(String name, Msisdn number) {
    public RobotName {
        if (!name.matches("[\\p{L}\\p{N}_.+-]+")) {
            throw new IllegalArgumentException(
                    "expected a robot's name of letters, digits and _ . + -, found \"" + name + "\"");
        }
    }

    /** Reads {@code NAME=NUMBER}. */
    public static RobotName parse(String text) {
        int equals = text.lastIndexOf('=');
        if (equals < 0) {
            throw new IllegalArgumentException("expected NAME=NUMBER, found " + text);
        }
        return new RobotName(
                text.substring(0, equals),
                Msisdn.parse(text.substring(equals + 1)).plain());
    }
}
