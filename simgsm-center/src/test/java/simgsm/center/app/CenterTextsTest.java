package simgsm.center.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Properties;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The centre's texts: both languages say the same things, every text is used, no two buttons share a mnemonic. */
class CenterTextsTest {
    private final Properties english = load("messages.properties");
    private final Properties spanish = load("messages_es.properties");

    @Test
    void bothLanguagesHaveTheSameKeys() {
        assertEquals(english.keySet(), spanish.keySet());
    }

    @Test
    void bothLanguagesTakeTheSameNumberOfParameters() {
        for (String key : english.stringPropertyNames()) {
            assertEquals(parameters(english, key), parameters(spanish, key), key);
        }
    }

    @Test
    void everyTextIsUsed() throws IOException {
        String sources = sources();
        for (String key : english.stringPropertyNames()) {
            String family = key.substring(0, key.lastIndexOf('.') + 1);
            boolean isWhy = key.endsWith(".why") && sources.contains("\".why\"");
            assertTrue(
                    isWhy || sources.contains("\"" + key + "\"") || sources.contains("\"" + family + "\""),
                    key + " is not used");
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void noMnemonicIsThereTwice(String language) {
        Properties texts = language.equals("en") ? english : spanish;
        Map<Character, String> mnemonics = new HashMap<>();
        for (String key : texts.stringPropertyNames()) {
            int mark = texts.getProperty(key).indexOf('&');
            if (mark >= 0) {
                char mnemonic = Character.toUpperCase(texts.getProperty(key).charAt(mark + 1));
                String other = mnemonics.put(mnemonic, key);
                assertTrue(other == null, key + " and " + other + " share " + mnemonic);
            }
        }
        assertTrue(mnemonics.size() > 3);
    }

    private static int parameters(Properties texts, String key) {
        return new MessageFormat(texts.getProperty(key), Locale.ROOT).getFormatsByArgumentIndex().length;
    }

    private static Properties load(String name) {
        Properties texts = new Properties();
        try (InputStream in = CenterTextsTest.class.getResourceAsStream(name)) {
            texts.load(new InputStreamReader(in, StandardCharsets.UTF_8));
            return texts;
        } catch (IOException impossible) {
            throw new AssertionError(impossible);
        }
    }

    private static String sources() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .map(CenterTextsTest::read)
                    .collect(Collectors.joining());
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException impossible) {
            throw new AssertionError(impossible);
        }
    }
}
