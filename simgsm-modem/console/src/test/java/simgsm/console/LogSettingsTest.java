package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.logging.Level;
import java.util.logging.LogRecord;
import org.junit.jupiter.api.Test;

class LogSettingsTest {
    @Test
    void aRecordWithAPeersControlCharactersIsOneLineWithoutThem() {
        LogRecord record = new LogRecord(Level.WARNING, "refused as \"{0}\"");
        record.setLoggerName("simgsm.test");
        record.setParameters(new Object[] {"e\u001b[31mx\r\nFAKE\u0085\u2028\t\u0000\u007f C:\\new"});
        record.setThrown(new IllegalStateException("two\nlines"));

        String line = new LogSettings.OneLine().format(record);

        assertTrue(
                line.endsWith(" WARNING simgsm.test: refused as"
                        + " \"e\\u001b[31mx\\r\\nFAKE\\u0085\\u2028\\t\\u0000\\u007f C:\\new\""
                        + " (java.lang.IllegalStateException: two\\nlines)\n"),
                line);
        assertEquals(line.length() - 1, line.indexOf('\n'));
    }
}
