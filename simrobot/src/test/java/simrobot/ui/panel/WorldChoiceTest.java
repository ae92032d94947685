package simrobot.ui.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simrobot.ui.OperatorActions;
import simrobot.ui.SimRobotTexts;

class WorldChoiceTest {
    private static final Path WORLDS = Path.of("..", "worlds");

    @TempDir
    private Path folder;

    private final List<Path> loaded = new ArrayList<>();
    private List<Path> recent = List.of();

    private final OperatorActions operator = (OperatorActions) Proxy.newProxyInstance(
            OperatorActions.class.getClassLoader(), new Class<?>[] {OperatorActions.class}, (proxy, method, words) -> {
                if (method.getName().equals("load")) {
                    loaded.add((Path) words[0]);
                }
                return method.getName().equals("recentWorlds") ? recent : null;
            });

    private WorldChoice choice(Path shown, Locale language) {
        WorldChoice choice = new WorldChoice(SimRobotTexts.in(language), operator, isNew -> {});
        choice.show(shown);
        return choice;
    }

    private static List<String> lines(WorldChoice choice) {
        return Stream.of(choice.menu().getComponents())
                .flatMap(entry -> entry instanceof JMenuItem item
                        ? Stream.of(item.getText())
                        : entry instanceof JLabel label ? Stream.of("[" + label.getText() + "]") : Stream.of())
                .toList();
    }

    private Path own(String name) throws Exception {
        return Files.writeString(folder.resolve(name), "2D-Map\nLINES\n0 0 1 1\n");
    }

    @Test
    void eachShippedWorldSaysWhatItIsFor() {
        for (Locale language : List.of(Locale.ENGLISH, Locale.forLanguageTag("es"))) {
            List<String> lines = lines(choice(WORLDS.resolve("maze.map"), language));
            for (int i = 0; i < ShippedWorlds.NAMES.size(); i++) {
                assertTrue(lines.get(i).matches(ShippedWorlds.NAMES.get(i) + "  \u2013  .{10,60}"), lines.get(i));
            }
        }
        assertEquals(
                "office.map  \u2013  salas junto a un pasillo: viajes de varios tramos",
                lines(choice(WORLDS.resolve("maze.map"), Locale.forLanguageTag("es")))
                        .get(1));
    }

    @Test
    void anotherWorldOfTheSameNameSaysNothing() throws Exception {
        own("maze.map");
        assertEquals(
                "maze.map",
                lines(choice(folder.resolve("maze.map"), Locale.ENGLISH)).get(0));
    }

    @Test
    void inAFolderOfOnesOwnStandRecentWorldsAndThoseOfTheProgramToo() throws Exception {
        Path mine = own("mine.map");
        own("zoo.wld");
        Files.writeString(folder.resolve("picture.png"), "");
        Path elsewhere = WORLDS.resolve("office.map").toAbsolutePath().normalize();
        recent = List.of(mine, elsewhere);
        WorldChoice choice = choice(mine, Locale.ENGLISH);
        List<String> lines = lines(choice);
        assertEquals(List.of("mine.map", "zoo.wld", "[Recent worlds]"), lines.subList(0, 3));
        assertEquals("office.map  \u2013  in " + elsewhere.getParent(), lines.get(3));
        assertEquals("[Worlds of the program]", lines.get(4));
        assertTrue(lines.get(5).startsWith("demo.map  \u2013  "), lines.get(5));
        assertFalse(lines.contains("picture.png"));
        ((JMenuItem) Stream.of(choice.menu().getComponents())
                        .filter(entry -> entry instanceof JMenuItem item
                                && item.getText().startsWith("demo.map"))
                        .findFirst()
                        .orElseThrow())
                .doClick(0);
        assertEquals(List.of(Path.of("worlds", "demo.map")), loaded);
    }

    @Test
    void theJarAloneOffersTheWorldsThatItCarries() {
        List<String> lines = lines(choice(Path.of("worlds", "demo.map"), Locale.ENGLISH));
        assertTrue(lines.get(5).startsWith("empty.map  \u2013  "), lines.get(5));
        assertFalse(lines.contains("[Worlds of the program]"));
    }
}
