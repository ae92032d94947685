package simgsm.modem.at;

/**
 * One command of a line.
 *
 * @param name in capitals with its prefix, such as {@code +CMGS}, {@code &F}, {@code D}
 * @param parameters what follows the name; for SET what follows the equals sign
 */
public record AtCommand(String name, Form form, String parameters) {
    /** The forms of a command (V.250, 5.4). Basic commands have the first only. */
    public enum Form {
        EXECUTE,
        READ,
        TEST,
        SET
    }
}
