package simgsm.modem.client;

import java.util.Locale;

/** The verdict on a modem by its answer to a set-up command. */
public enum SetupVerdict {
    OK,
    /** The command is refused, or not answered. */
    MISSING,
    /** The command is accepted, with an unexpected answer. */
    UNEXPECTED;

    /** For reports. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
