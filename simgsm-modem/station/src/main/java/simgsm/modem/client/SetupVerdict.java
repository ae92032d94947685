package simgsm.modem.client;

import java.util.Locale;

/** What the answer to a command of the set-up says about a modem. */
public enum SetupVerdict {
    OK,
    /** The command is refused, or has no answer. */
    MISSING,
    /** The command is accepted, with an answer that does not fit. */
    UNEXPECTED;

    /** As reports have it. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
