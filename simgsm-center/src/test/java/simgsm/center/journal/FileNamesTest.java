package simgsm.center.journal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Names of the journal's files. */
class FileNamesTest {
    @Test
    void numbersAreWrittenInAsciiDigitsWhateverTheSystemsLanguage() {
        Locale before = Locale.getDefault();
        Locale.setDefault(Locale.forLanguageTag("ar-EG"));
        try {
            assertEquals("segment-0000000012", FileNames.segment(12));
            assertEquals(Optional.of(12L), FileNames.segmentNumber(FileNames.segment(12)));
            assertEquals(Optional.of(3L), FileNames.snapshotNumber(FileNames.snapshot(3)));
        } finally {
            Locale.setDefault(before);
        }
    }
}
