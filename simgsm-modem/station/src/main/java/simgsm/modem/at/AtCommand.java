package simgsm.modem.at;

/**
 * One command of a line.
 *
 * @param name in capitals with its prefix, such as {@code +CMGS}, {@code &F}, {@code D}
 * @param parameters text after the name; for SET after the equals sign
 */
public record AtCommand(String name, Form form, String parameters) {
    /** The forms of a command (V.250, 5.4). Basic commands have only the first. */
    public enum Form {
        EXECUTE,
        READ,
        TEST,
        SET
    }
}
