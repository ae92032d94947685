package simgsm.station.context;

import java.lang.System.Logger.Level;

/** The log of one station: each line begins with the station's number. */
public final class StationLog {
    private static final System.Logger LOGGER = System.getLogger("simgsm.station");

    private final String prefix;

    public StationLog(StationIdentity identity) {
        prefix = identity.number() + ": ";
    }

    /** @param format with {@code {0}} and so on for the arguments; an apostrophe is written twice */
    public void trace(Level level, String format, Object... arguments) {
        if (LOGGER.isLoggable(level)) {
            LOGGER.log(level, prefix + format, arguments);
        }
    }
}
