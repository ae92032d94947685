package simgsm.modem;

import java.util.Locale;

/** Whether a modem can serve, and what hinders it. */
public enum ModemState {
    READY,
    /** The line is down, or a command has no answer. */
    SILENT,
    SIM_PIN,
    SIM_PUK,
    NO_SIM,
    /** Not registered. */
    NO_NETWORK;

    /** The name in events, such as {@code sim-pin}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
