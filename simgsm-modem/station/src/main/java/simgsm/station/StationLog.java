package simgsm.station;

import java.lang.System.Logger.Level;

/** One station's lines in the log: each begins with its number. */
final class StationLog {
    private static final System.Logger LOGGER = System.getLogger("simgsm.station");

    private final String prefix;

    StationLog(StationIdentity identity) {
        prefix = identity.number() + ": ";
    }

    void trace(Level level, String format, Object... arguments) {
        if (LOGGER.isLoggable(level)) {
            LOGGER.log(level, prefix + format, arguments);
        }
    }

    /** An event that the machine's present state does not accept. */
    void refused(Enum<?> state, Enum<?> event) {
        trace(Level.DEBUG, "{0} refuses {1}", state, event);
    }
}
