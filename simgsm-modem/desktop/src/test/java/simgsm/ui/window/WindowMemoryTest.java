package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.console.Arguments;
import simgsm.console.Options;

class WindowMemoryTest {
    private static final List<WindowPlace> SCREEN = List.of(new WindowPlace(0, 0, 1920, 1080));
    private static final List<WindowPlace> OTHER_SCREEN = List.of(new WindowPlace(0, 0, 1280, 720));
    private static final WindowPlace PLACE = new WindowPlace(30, -5, 800, 600);

    @TempDir
    private Path home;

    private WindowMemory memory;

    @BeforeEach
    void memory() {
        memory = new WindowMemory(home.resolve("settings/simgsm"));
    }

    @Test
    void aWindowOpensAsItWasLeft() throws Exception {
        memory.keep("robot", PLACE, 125, SCREEN);
        memory.keep("theme", "dark");
        memory.keep("lang", "es");
        Arguments recalled = memory.recall(given(), "robot", SCREEN);
        assertEquals(Optional.of(PLACE.toString()), recalled.text("window"));
        assertEquals(Optional.of("125"), recalled.text("zoom"));
        assertEquals(Optional.of("dark"), recalled.text("theme"));
        assertEquals("es", recalled.language().getLanguage());
    }

    @Test
    void anotherWindowHasItsOwnPlaceAndTheSameColours() throws Exception {
        memory.keep("robot", PLACE, 125, SCREEN);
        memory.keep("theme", "contrast");
        Arguments recalled = memory.recall(given(), "phone", SCREEN);
        assertFalse(recalled.has("window"));
        assertFalse(recalled.has("zoom"));
        assertEquals(Optional.of("contrast"), recalled.text("theme"));
    }

    @Test
    void optionsOfTheCommandLineWin() throws Exception {
        memory.keep("robot", PLACE, 125, SCREEN);
        memory.keep("theme", "dark");
        Arguments recalled = memory.recall(given("--zoom", "150", "--theme", "light"), "robot", SCREEN);
        assertEquals(Optional.of("150"), recalled.text("zoom"));
        assertEquals(Optional.of("light"), recalled.text("theme"));
        assertFalse(recalled.has("window"), "the place belongs to another zoom");
    }

    @Test
    void aPlaceOnOtherScreensIsLeftOut() throws Exception {
        memory.keep("robot", PLACE, 125, SCREEN);
        assertFalse(memory.recall(given(), "robot", OTHER_SCREEN).has("window"));
    }

    @Test
    void aNameOfTheCommandLineTellsWindowsOfOneProgramApart() throws Exception {
        memory.keep("demo-robot", PLACE, 100, SCREEN);
        assertTrue(memory.recall(given("--remember-as", "demo-robot"), "robot", SCREEN)
                .has("window"));
        assertFalse(memory.recall(given(), "robot", SCREEN).has("window"));
    }

    @Test
    void valuesThatMakeNoSenseAreLeftOut() throws Exception {
        memory.keep("robot", PLACE, 100, SCREEN);
        Path file = home.resolve("settings/simgsm/robot.properties");
        Files.writeString(file, "zoom=9000\nwindow=here\nscreen=" + SCREEN + "\ntheme=pink\nlang=xx\nport=1\n");
        Arguments recalled = memory.recall(given(), "robot", SCREEN);
        for (String option : List.of("zoom", "window", "theme", "lang", "port", "screen")) {
            assertFalse(recalled.has(option), option);
        }
        Files.writeString(file, "zoom=\\uZZZZ");
        assertFalse(memory.recall(given(), "robot", SCREEN).has("zoom"));
    }

    @Test
    void whatIsForgottenIsNotRecalled() throws Exception {
        memory.keep("robot", PLACE, 100, SCREEN);
        memory.keep("lang", "es");
        memory.forget();
        assertFalse(memory.recall(given(), "robot", SCREEN).has("lang"));
    }

    @Test
    void whereNothingCanBeWrittenNothingIsRemembered() throws Exception {
        WindowMemory none =
                new WindowMemory(Files.writeString(home.resolve("file"), "").resolve("folder"));
        none.keep("robot", PLACE, 100, SCREEN);
        assertFalse(none.recall(given(), "robot", SCREEN).has("window"));
        none.forget();
        assertFalse(none.recall(given(), "robot", SCREEN).has("window"));
    }

    @Test
    void withoutADisplayOrFreshNothingIsRecalled() throws Exception {
        assertFalse(WindowMemory.recall(given("--headless"), "robot").has("remember-as"));
        assertFalse(WindowMemory.recall(given("--fresh"), "robot").has("remember-as"));
    }

    @Test
    void programsThatAreStartedRememberNothingWhereThisOneDoesNot() throws Exception {
        assertEquals(List.of(), WindowMemory.passedOn(given("--remember-as", "center")));
        assertEquals(List.of("--fresh"), WindowMemory.passedOn(given("--remember-as", "center", "--fresh")));
        assertEquals(List.of("--fresh"), WindowMemory.passedOn(given()));
    }

    @Test
    void theFolderIsThatOfTheUsersSettings() {
        Properties system = new Properties();
        system.setProperty("user.home", home.toString());
        system.setProperty("os.name", "Linux");
        assertEquals(home.resolve(".config/simgsm"), WindowMemory.folder(Map.of(), system));
        Path elsewhere = home.resolve("elsewhere");
        assertEquals(
                elsewhere.resolve("simgsm"),
                WindowMemory.folder(Map.of("XDG_CONFIG_HOME", elsewhere.toString()), system));
        assertEquals(home.resolve(".config/simgsm"), WindowMemory.folder(Map.of("XDG_CONFIG_HOME", "here"), system));
    }

    private static Arguments given(String... words) throws Exception {
        return new Options("robot", "A robot.").rows("include common").parse(List.of(words));
    }
}
