package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SharedSettingsTest {
    @TempDir
    private Path folder;

    /** A window of a process of its own. */
    private final class OneWindow {
        private final Map<String, String> has;
        private final SharedSettings shared;

        OneWindow(String theme, String language) {
            has = new TreeMap<>(Map.of("theme", theme, "lang", language));
            shared = new SharedSettings(new WindowMemory(folder), () -> Map.copyOf(has), has::putAll);
        }
    }

    @Test
    void aChangeInOneWindowReachesTheOthers() {
        OneWindow center = new OneWindow("light", "en");
        OneWindow robot = new OneWindow("light", "en");
        center.has.put("lang", "es");
        center.shared.look();
        robot.shared.look();
        assertEquals("es", robot.has.get("lang"));
        robot.has.put("theme", "contrast");
        robot.shared.look();
        center.shared.look();
        assertEquals(Map.of("theme", "contrast", "lang", "es"), center.has);
    }

    @Test
    void whatAWindowWasStartedWithStaysUntilSomethingIsChanged() {
        OneWindow first = new OneWindow("dark", "es");
        first.has.put("theme", "light");
        first.shared.look();
        OneWindow second = new OneWindow("dark", "en");
        second.shared.look();
        first.shared.look();
        assertEquals(Map.of("theme", "dark", "lang", "en"), second.has);
        first.has.put("theme", "contrast");
        first.shared.look();
        second.shared.look();
        assertEquals(Map.of("theme", "contrast", "lang", "en"), second.has);
    }

    @Test
    void whatFitsNoWindowIsNotTakenOver() {
        OneWindow window = new OneWindow("light", "en");
        new WindowMemory(folder).keep("theme", "purple");
        new WindowMemory(folder).keep("lang", "fr");
        window.shared.look();
        assertEquals(Map.of("theme", "light", "lang", "en"), window.has);
    }
}
