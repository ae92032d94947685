package simrobot.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Properties;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import simgsm.event.EventForm;
import simrobot.control.RobotEvent;
import simrobot.ui.editor.EditorTool;
import vericommand.RobotStatus;

/** Both bundles have the same keys, and every key is used. */
class SimRobotTextsTest {
    private static final Path FOLDER = Path.of("src", "main", "resources", "simrobot", "ui");
    private static final Path SOURCES = Path.of("src", "main", "java", "simrobot", "ui");

    private static Properties load(String file) throws IOException {
        Properties bundle = new Properties();
        try (var reader = Files.newBufferedReader(FOLDER.resolve(file), StandardCharsets.UTF_8)) {
            bundle.load(reader);
        }
        return bundle;
    }

    @Test
    void bothLanguagesHaveTheSameKeysAndPlaces() throws Exception {
        Properties english = load("messages.properties");
        Properties spanish = load("messages_es.properties");
        assertEquals(new TreeSet<>(english.keySet()), new TreeSet<>(spanish.keySet()));
        for (String key : english.stringPropertyNames()) {
            assertEquals(places(english.getProperty(key)), places(spanish.getProperty(key)), key);
        }
    }

    private static String places(String text) {
        return text.chars()
                .filter(Character::isDigit)
                .mapToObj(digit -> text.contains("{" + (char) digit + "}") ? "" + (char) digit : "")
                .sorted()
                .collect(Collectors.joining());
    }

    @Test
    void everyKeyIsUsed() throws Exception {
        StringBuilder sources = new StringBuilder();
        try (Stream<Path> files = Files.walk(SOURCES)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                sources.append(Files.readString(file));
            }
        }
        for (String key : load("messages.properties").stringPropertyNames()) {
            String last = key.substring(key.lastIndexOf('.') + 1);
            boolean composed = key.startsWith("tool.") || key.startsWith("status.");
            assertTrue(
                    sources.indexOf('"' + key + '"') >= 0
                            || composed
                                    && sources.indexOf('"' + key.substring(5).replace(".word", "") + '"') >= 0
                            || key.startsWith("world.about.") && sources.indexOf('"' + last + ".map\"") >= 0
                            || isOfTheEditor(key, last, sources)
                            || isOfAnEvent(key)
                            || isStatus(last),
                    key);
        }
    }

    /** The editor composes the keys of its tools, fields and actions. */
    private static boolean isOfTheEditor(String key, String last, CharSequence sources) {
        boolean tool = EditorTool.ALL.stream().anyMatch(each -> each.id().equals(last));
        boolean field = key.startsWith("editor.field.");
        return key.startsWith("editor.") && (tool || field || sources.toString().contains("action(\"" + last + '"'));
    }

    /** The log composes its keys of the names of events, some with a value. */
    private static boolean isOfAnEvent(String key) {
        String[] parts = key.split("\\.");
        return parts[0].equals("log")
                && (parts[1].equals("type-unknown")
                        || Stream.of(RobotEvent.class.getPermittedSubclasses())
                                .anyMatch(event -> EventForm.of(event).name().equals(parts[1])));
    }

    private static boolean isStatus(String word) {
        return Stream.of(RobotStatus.values())
                .anyMatch(status -> status.name().toLowerCase(Locale.ROOT).equals(word));
    }
}
