package simgsm.modem;

import java.util.Locale;

/** The service of a modem: ready, or the obstacle. */
public enum ModemState {
    READY,
    /** The line is down, or a command was not answered. */
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
