package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What is written and read again is the same world, to the last bit. */
class MapWriterTest {
    @TempDir
    Path folder;

    static Stream<Path> ourWorlds() throws IOException {
        return Files.list(Path.of("..", "worlds"))
                .filter(file -> file.toString().endsWith(".map"));
    }

    private static World again(World world) throws Exception {
        return MapReader.read(world.name(), MapWriter.text(world));
    }

    @ParameterizedTest
    @MethodSource("ourWorlds")
    void ourWorldsSurviveWritingAndReading(Path file) throws Exception {
        World world = WorldReader.read(file);
        assertEquals(world, again(world));
    }

    @Test
    void wallsAndPointsOfAnyCoordinatesSurviveToTheLastBit() throws Exception {
        Random random = new Random(7);
        List<Segment> walls = new ArrayList<>();
        List<Point> points = new ArrayList<>();
        for (int i = 0; i < 2000; i++) {
            double scale = Math.pow(10, random.nextInt(12) - 6);
            walls.add(new Segment(
                    scale * random.nextGaussian(), scale * random.nextGaussian(), i / 1000.0, -0.1 * i - 0.1));
            points.add(new Point(scale * random.nextGaussian(), Math.nextUp(i / 3.0)));
        }
        WorldBuilder builder = new WorldBuilder("w").pointDiameter(0.05);
        walls.forEach(builder::add);
        points.forEach(builder::add);
        World world = builder.build();
        World again = again(world);
        for (int i = 0; i < walls.size(); i++) {
            assertEquals(walls.get(i), again.items(Segment.class).get(i));
            assertEquals(points.get(i), again.items(Point.class).get(i));
        }
    }

    @Test
    void aNestedSaphiraWorldKeepsItsSegmentsAsAMap() throws Exception {
        World nested = SaphiraReader.read(
                "n.wld",
                "push 100.5 -20 33.3\r\npush 7 8 -121.7\r\n0 0 1000 0\r\n3 4 5.25 6\r\npop\r\n1 2 3 4\r\npop\r\n");
        assertEquals(nested.items(Segment.class), again(nested).items(Segment.class));
    }

    @Test
    void everythingThatAMapHoldsIsWritten() throws Exception {
        World world = MapReader.read(
                "all.map",
                "2D-Map\r\nNumLines: 99\r\nResolution: 30\r\n"
                        + "Cairn: RobotHome 1000 2000 45 \"\" ICON \"My \\\"home\\\"\" 900 1900 1100 2100\r\n"
                        + "Cairn: RobotHome 1 2 -33.3\r\n"
                        + "Cairn: GoalWithHeading 5 6 90 \"\" ICON \"Exit\"\r\n"
                        + "Cairn: Dock 7 8 180 \"\" ICON \"\"\r\n"
                        + "Cairn: ForbiddenLine 0 0 0 \"\" ICON \"\" 1 2 3 4.5\r\n"
                        + "Cairn: ForbiddenArea 0 0 30 \"\" ICON \"\" 1 2 30 40\r\n"
                        + "Cairn: Sim.BoxObstacle 0 0 15.5 \"\" ICON \"Desk\" 10 20 300 400\r\n"
                        + "Cairn: Sim.Treadmill 0 0 -90 \"\" ICON \"v=-312.5\" 10 20 300 400\r\n"
                        + "LINES\r\n0 0 1000.125 -2.5e2\r\nDATA\r\n1 2\r\n");
        World again = again(world);
        assertEquals(world, again);
        assertEquals("My \"home\"", again.items(Home.class).get(0).name());
        assertEquals(0.03, again.pointDiameterMeters());
        assertEquals("GoalWithHeading", again.items(Goal.class).get(0).type());
    }

    @Test
    void theCentreOfABoxIsAsRoundAsItsCorners() throws Exception {
        String text = MapWriter.text(WorldReader.read(Path.of("..", "worlds", "demo.map")));
        assertTrue(text.contains(" 1100 2000 0 \"\" ICON \"Workbench\" 300 1700 1900 2300"), text);
    }

    @Test
    void headersTellWhatIsThere() {
        String text = MapWriter.text(World.of("w", List.of(new Segment(-1, 0.5, 2, 0.3))));
        assertTrue(text.startsWith("2D-Map\nLineMinPos: -1000 300\nLineMaxPos: 2000 500\nNumLines: 1\n"), text);
        assertTrue(text.endsWith("LINES\n-1000 500 2000 300\nDATA\n"), text);
    }

    @Test
    void roundDegreesStayRound() {
        for (int degrees = -720; degrees <= 720; degrees++) {
            assertEquals(String.valueOf(degrees), MapWriter.degrees(Math.toRadians(degrees)));
        }
    }

    @Test
    void aFileIsSavedAndReplaced() throws Exception {
        Path file = folder.resolve("w.map");
        World first = World.of("w.map", List.of(new Segment(0, 0, 1, 0)));
        MapWriter.save(first, file);
        assertEquals(first, WorldReader.read(file));
        World second = first.toBuilder()
                .add(new Home("A", new Position(1, 2), 0.5, Optional.empty()))
                .build();
        MapWriter.save(second, file);
        assertEquals(second.items(Segment.class), WorldReader.read(file).items(Segment.class));
        assertEquals("A", WorldReader.read(file).items(Home.class).get(0).name());
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(List.of(file), left.toList());
        }
    }

    @Test
    void whatCannotBeWrittenIsNamed() throws Exception {
        World world = World.bare();
        Path nowhere = folder.resolve("nowhere").resolve("w.map");
        assertTrue(assertThrows(IOException.class, () -> MapWriter.save(world, nowhere))
                .getMessage()
                .endsWith("w.map: the folder does not exist"));
        assertTrue(assertThrows(IOException.class, () -> MapWriter.save(world, folder))
                .getMessage()
                .endsWith("expected a file, found a folder"));
    }
}
