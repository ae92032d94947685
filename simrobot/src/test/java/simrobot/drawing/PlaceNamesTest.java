package simrobot.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simrobot.world.Box;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.World;
import simrobot.world.WorldReader;

class PlaceNamesTest {
    private static final PlaceNames SPANISH = PlaceNames.in(Locale.forLanguageTag("es"));

    @ParameterizedTest
    @CsvSource({
        "Desk, Escritorio",
        "Desk 2, Escritorio 2",
        "Office1, Oficina1",
        "Bench A, Banco A",
        "Dolores, Dolores",
        "Desk of Ann, Desk of Ann",
        "D, D"
    })
    void usualNamesAreSpanishAndOthersAsTheyAre(String name, String shown) {
        assertEquals(shown, SPANISH.of(name));
        assertEquals(name, PlaceNames.in(Locale.ENGLISH).of(name));
        assertEquals(name, PlaceNames.OF_FILE.of(name));
    }

    @Test
    void everyNameInOurWorldsIsKnown() throws Exception {
        List<String> same = List.of("Sof\u00e1", "Sofa", "");
        try (Stream<Path> files = Files.list(Path.of("..", "worlds"))) {
            for (Path file :
                    files.filter(each -> each.toString().endsWith(".map")).toList()) {
                World world = WorldReader.read(file);
                Stream.of(
                                world.items(Box.class).stream().map(Box::name),
                                world.items(Home.class).stream().map(Home::name),
                                world.items(Goal.class).stream().map(Goal::name))
                        .flatMap(names -> names)
                        .filter(name -> !same.contains(name))
                        .forEach(name -> assertNotEquals(name, SPANISH.of(name), file + ": " + name));
            }
        }
    }
}
