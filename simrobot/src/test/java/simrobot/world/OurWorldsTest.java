package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every world of ours loads, and a robot fits on each of its homes. */
class OurWorldsTest {
    private static final Path FOLDER = Path.of("..", "worlds");

    static List<Path> worlds() throws Exception {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".map"))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("worlds")
    void loadsWithHomesThatAreFree(Path file) throws Exception {
        World world = WorldReader.read(file);
        ObstacleGrid grid = new ObstacleGrid(world);
        assertFalse(world.items(Home.class).isEmpty());
        for (Home home : world.items(Home.class)) {
            double gap =
                    grid.clearance(home.position().xMeters(), home.position().yMeters(), 1);
            assertTrue(gap >= 0.3, home + " is " + gap + " m from an obstacle");
        }
        assertEquals(
                world.items(Home.class).size(),
                world.items(Home.class).stream().map(Home::name).distinct().count());
    }

    @Test
    void theEmptyHallIsTwentyMetresSquareWithTheHomeInItsMiddle() throws Exception {
        World hall = WorldReader.read(FOLDER.resolve("empty.map"));
        assertEquals(new Area(-10, -10, 10, 10, 0), hall.bounds());
        assertEquals(new Position(0, 0), hall.items(Home.class).get(0).position());
        assertEquals(0, hall.items(Home.class).get(0).headingRadians());
        assertEquals(4, hall.items(Segment.class).size());
    }

    @Test
    void theWorldsThatTheGuideNamesAreThere() throws Exception {
        List<String> names =
                worlds().stream().map(file -> file.getFileName().toString()).toList();
        assertTrue(names.containsAll(
                List.of("corridor.map", "demo.map", "empty.map", "maze.map", "office.map", "treadmill.map")));
    }
}
