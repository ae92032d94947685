package simgsm.classroom.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class ClassroomTextsTest {
    private static Properties load(String name) throws IOException {
        Properties texts = new Properties();
        try (InputStream in = ClassroomTextsTest.class.getResourceAsStream(name)) {
            texts.load(new InputStreamReader(in, StandardCharsets.UTF_8));
        }
        return texts;
    }

    private static Map<String, Integer> parameters(Properties texts) {
        Map<String, Integer> parameters = new TreeMap<>();
        texts.stringPropertyNames()
                .forEach(key -> parameters.put(
                        key,
                        new MessageFormat(texts.getProperty(key), Locale.ROOT).getFormatsByArgumentIndex().length));
        return parameters;
    }

    @Test
    void bothLanguagesHaveTheSameKeysWithTheSameNumberOfParameters() throws IOException {
        assertEquals(parameters(load("messages.properties")), parameters(load("messages_es.properties")));
    }

    @Test
    void everyTextIsUsed() throws IOException {
        StringBuilder sources = new StringBuilder();
        try (Stream<Path> files = Files.walk(Path.of("src/main"))) {
            for (Path file : files.filter(Files::isRegularFile)
                    .filter(file -> !file.toString().endsWith(".properties"))
                    .toList()) {
                sources.append(Files.readString(file));
            }
        }
        List<String> unused = load("messages.properties").stringPropertyNames().stream()
                .filter(key -> !isUsed(key, sources.toString()))
                .sorted()
                .toList();
        assertEquals(List.of(), unused);
    }

    /** Also as the explanation of another text, a column of the class's table, or a heading of the demo's script. */
    private static boolean isUsed(String key, String sources) {
        String last = key.substring(key.indexOf('.') + 1).replaceFirst("[.]why$", "");
        return sources.contains('"' + key + '"')
                || sources.contains("== " + key + "\n")
                || sources.contains('"' + key.replaceFirst("[.]why$", "") + '"')
                || (key.startsWith("class.") && sources.contains('"' + last + '"'));
    }
}
