package simgsm.phone;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import simgsm.console.TextBundle;

/** The phone's texts: both languages say the same things, and every text is used. */
class BundleTest {
    private static final String NAME = "simgsm.phone.messages";
    private final ResourceBundle english = ResourceBundle.getBundle(NAME, Locale.ROOT);
    private final ResourceBundle spanish = ResourceBundle.getBundle(NAME, Locale.forLanguageTag("es"));

    @Test
    void spanishHasItsOwnTextForEveryEnglishKeyAndNoOther() {
        assertEquals(new TreeSet<>(english.keySet()), new TreeSet<>(ownKeys(spanish)));
    }

    private static Set<String> ownKeys(ResourceBundle bundle) {
        // A PropertyResourceBundle's own keys, without its parent's, are what its enumeration of handled keys gives.
        return bundle.keySet().stream()
                .filter(key -> ((java.util.PropertyResourceBundle) bundle).handleGetObject(key) != null)
                .collect(Collectors.toSet());
    }

    /** A menu with two rows of one text cannot be used. */
    @Test
    void sendingAgainAndForwardingHaveDifferentTextsInBothLanguages() {
        for (ResourceBundle bundle : List.of(english, spanish)) {
            assertNotEquals(bundle.getString("option.forward"), bundle.getString("soft.again"));
            assertNotEquals(bundle.getString("option.forward"), bundle.getString("option.again"));
        }
    }

    @Test
    void bothLanguagesTakeTheSameNumberOfParameters() {
        for (String key : english.keySet()) {
            assertEquals(parameters(english, key), parameters(spanish, key), key);
        }
    }

    private static int parameters(ResourceBundle bundle, String key) {
        return new MessageFormat(bundle.getString(key), Locale.ROOT).getFormatsByArgumentIndex().length;
    }

    @Test
    void everyTextIsUsed() throws IOException {
        String sources = sources();
        for (String key : english.keySet()) {
            String family = key.substring(0, key.lastIndexOf('.') + 1);
            assertTrue(
                    sources.contains("\"" + key + "\"") || sources.contains("\"" + family + "\""),
                    key + " is not used");
        }
    }

    private static String sources() throws IOException {
        StringBuilder all = new StringBuilder();
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            for (Path file :
                    files.filter(path -> path.toString().endsWith(".java")).toList()) {
                all.append(Files.readString(file));
            }
        }
        return all.toString();
    }

    @Test
    void englishIsEnglishWhateverTheSystemSpeaks() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag("es"));
            assertEquals("executed", PhoneTexts.in(Locale.ENGLISH).of("tone.3"));
            assertEquals(
                    "ejecutada", PhoneTexts.in(Locale.forLanguageTag("es-MX")).of("tone.3"));
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void aMissingKeyShowsAsItself() {
        assertEquals("no.such.key", PhoneTexts.in(Locale.ENGLISH).of("no.such.key"));
    }

    @Test
    void pluralsAreChosen() {
        TextBundle texts = PhoneTexts.in(Locale.ENGLISH);
        assertEquals("1 new message", texts.of("lcd.unread", 1));
        assertEquals("12 new messages", texts.of("lcd.unread", 12));
    }
}
