package simgsm.console;

import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Map;
import java.util.logging.ConsoleHandler;
import java.util.logging.Formatter;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import simgsm.file.LineText;

/** Writes log records at or above a level to standard error, a line each. */
final class LogSettings {
    private static final Map<String, Level> LEVELS = Map.of(
            "off", Level.OFF,
            "error", Level.SEVERE,
            "warning", Level.WARNING,
            "info", Level.INFO,
            "debug", Level.FINE,
            "trace", Level.FINER);
    /** The level without {@code --log-level}. */
    static final String DEFAULT = "info";
    /** The level of a program with a window, which prints nothing in a normal run. */
    static final String WITH_WINDOW = "warning";
    /** The root logger; the reference keeps its settings from garbage collection. */
    private static final Logger ROOT = Logger.getLogger("");
    /** The suite's packages; other packages log from warnings on. */
    private static final Logger[] OURS = {
        Logger.getLogger("simgsm"), Logger.getLogger("simrobot"), Logger.getLogger("vericommand")
    };

    private LogSettings() {}

    static void apply(String levelName) throws UsageException {
        Level level = LEVELS.get(levelName);
        if (level == null) {
            throw new UsageException(
                    "--log-level: expected off, error, warning, info, debug or trace, found " + levelName);
        }
        for (Handler handler : ROOT.getHandlers()) {
            ROOT.removeHandler(handler);
        }
        ConsoleHandler handler = new ConsoleHandler();
        handler.setFormatter(new OneLine());
        handler.setLevel(level);
        ROOT.addHandler(handler);
        ROOT.setLevel(Level.WARNING);
        for (Logger logger : OURS) {
            logger.setLevel(level);
        }
    }

    /** The level as a word of {@code --log-level}. */
    private static String word(Level level) {
        return LEVELS.entrySet().stream()
                .filter(entry -> entry.getValue().equals(level))
                .map(entry -> entry.getKey().toUpperCase(Locale.ROOT))
                .findFirst()
                .orElse(level.getName());
    }

    /** Control characters of a record, such as those of a peer's text, are escaped. */
    static final class OneLine extends Formatter {
        /** Created with the first record: most runs write none. */
        private DateTimeFormatter time;

        @Override
        public String format(LogRecord record) {
            if (time == null) {
                time = DateTimeFormatter.ofPattern("HH:mm:ss.SSS").withZone(ZoneId.systemDefault());
            }
            String thrown = record.getThrown() == null ? "" : " (" + record.getThrown() + ")";
            return time.format(Instant.ofEpochMilli(record.getMillis())) + " " + word(record.getLevel()) + " "
                    + record.getLoggerName() + ": " + LineText.escaped(formatMessage(record) + thrown) + "\n";
        }
    }
}
