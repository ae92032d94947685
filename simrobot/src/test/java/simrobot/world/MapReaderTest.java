package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class MapReaderTest {
    private static World read(String... lines) throws WorldFormatException {
        return MapReader.read("test.map", String.join("\n", lines) + "\n");
    }

    private static WorldFormatException fault(String... lines) {
        return assertThrows(WorldFormatException.class, () -> read(lines));
    }

    @Test
    void wallsAndPointsComeOutInMetres() throws Exception {
        World world = read("2D-Map", "LINES", "0 0 1000 -2500", "DATA", "-20 40");
        assertEquals(List.of(new Segment(0, 0, 1, -2.5)), world.items(Segment.class));
        assertEquals(List.of(new Point(-0.02, 0.04)), world.items(Point.class));
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "\r\n", "\r"})
    void everyKindOfLineEndIsRead(String end) throws Exception {
        World world = MapReader.read("test.map", String.join(end, "2D-Map", "LINES", "1 2 3 4", "DATA", "5 6"));
        assertEquals(1, world.items(Segment.class).size());
        assertEquals(1, world.items(Point.class).size());
    }

    @Test
    void countsThatLieAreNotBelieved() throws Exception {
        World world = read("2D-Map", "NumLines: 7", "NumPoints: 0", "LINES", "0 0 1 1", "1 1 2 2", "DATA", "3 3");
        assertEquals(2, world.items(Segment.class).size());
        assertEquals(1, world.items(Point.class).size());
    }

    @Test
    void missingHeadersAreNotMissed() throws Exception {
        assertEquals(1, read("2D-Map", "LINES", "0 0 1 1").items(Segment.class).size());
        assertEquals(0, read("2D-Map").items(Segment.class).size());
    }

    @Test
    void unknownHeadersAndCairnsAreSkippedWhateverTheyHold() throws Exception {
        World world = read(
                "2D-Map",
                "OriginLatLongAlt: 42.8 -71.5 0",
                "MapInfo: GoalType Name=Special \"an open quote",
                "Something-New: yes",
                "Cairn: Reflector not even numbers, and \"an open quote",
                "Cairn:",
                "LINES",
                "0 0 1 1");
        assertEquals(1, world.items(Segment.class).size());
    }

    @Test
    void emptyLinesAndCommentsAreSkippedEverywhere() throws Exception {
        World world = read("2D-Map", "", "# a remark", "LINES", "", "0 0 1 1", "; another", "DATA", "", "5 5");
        assertEquals(1, world.items(Segment.class).size());
        assertEquals(1, world.items(Point.class).size());
    }

    @Test
    void severalSectionsAddUp() throws Exception {
        World world = read("2D-Map", "DATA", "1 1", "LINES", "0 0 1 1", "LaserLINES", "1 1 2 2", "LaserDATA", "2 2");
        assertEquals(2, world.items(Segment.class).size());
        assertEquals(2, world.items(Point.class).size());
    }

    @Test
    void aHomeIsAPointWithHeadingAndName() throws Exception {
        Home home = read("2D-Map", "Cairn: RobotHome 1500 -250 90.000000 \"\" ICON \"Home 1\"", "LINES")
                .items(Home.class)
                .get(0);
        assertEquals(new Position(1.5, -0.25), home.position());
        assertEquals(Math.PI / 2, home.headingRadians(), 1e-15);
        assertEquals("Home 1", home.name());
        assertTrue(home.area().isEmpty());
    }

    @Test
    void aHomeAreaIsTurnedAboutTheMapsOrigin() throws Exception {
        Home home = read("2D-Map", "Cairn: RobotHome 0 2000 90 \"\" ICON \"Home\" 1000 -500 3000 500", "LINES")
                .items(Home.class)
                .get(0);
        assertTrue(home.area().orElseThrow().contains(0, 2));
        assertTrue(!home.area().orElseThrow().contains(2, 0));
        assertEquals(new Position(0, 2), home.position());
    }

    @Test
    void aHomeAreaWhosePointLiesOutsideStartsInItsMiddle() throws Exception {
        Home home = read("2D-Map", "Cairn: RobotHome 0 0 0 \"\" ICON \"Home\" 1000 1000 3000 2000", "LINES")
                .items(Home.class)
                .get(0);
        assertEquals(new Position(2, 1.5), home.position());
    }

    @Test
    void forbiddenLinesAndAreasAndGoalsAreKeptForDrawing() throws Exception {
        World world = read(
                "2D-Map",
                "Cairn: ForbiddenLine 0 0 0 \"\" ICON \"\" 0 0 1000 0",
                "Cairn: ForbiddenArea 0 0 0 \"\" ICON \"\" 2000 2000 1000 1000",
                "Cairn: GoalWithHeading 100 200 45 \"\" ICON \"Door\"",
                "LINES");
        assertEquals(List.of(new ForbiddenLine(new Segment(0, 0, 1, 0))), world.items(ForbiddenLine.class));
        assertEquals(List.of(new ForbiddenArea(new Area(1, 1, 2, 2, 0))), world.items(ForbiddenArea.class));
        assertEquals("Door", world.items(Goal.class).get(0).name());
        assertEquals(0, world.items(Segment.class).size());
    }

    @Test
    void aBoxIsAnObstacleWithFourSidesButNoLineOfTheMap() throws Exception {
        World world = read("2D-Map", "Cairn: Sim.BoxObstacle 0 0 0 \"\" ICON \"Desk\" 0 0 1000 500", "LINES");
        assertEquals(0, world.items(Segment.class).size());
        assertEquals(4, world.obstacles().size());
        assertEquals("Desk", world.items(Box.class).get(0).name());
    }

    @Test
    void aTreadmillRunsAlongItsHeadingAndItsCornersAreNotTurned() throws Exception {
        Treadmill belt = read("2D-Map", "Cairn: Sim.Treadmill 0 0 90 \"\" ICON \"v=-300\" 1000 0 2000 500", "LINES")
                .items(Treadmill.class)
                .get(0);
        assertTrue(belt.area().contains(1.5, 0.25));
        assertEquals(0, belt.velocityX(), 1e-15);
        assertEquals(-0.3, belt.velocityY(), 1e-15);
    }

    @Test
    void aNameMayHoldBlanksAndQuotes() throws Exception {
        World world = read("2D-Map", "Cairn: Goal 0 0 0 \"what \\\"this\\\" is\" ICON \"Don't \\\"stop\\\"\"", "LINES");
        assertEquals("Don't \"stop\"", world.items(Goal.class).get(0).name());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0 0 1|the end of the line|y2 in mm",
                "0 0 1 1 9|\"9\"|the end of the line",
                "0 0 x 1|\"x\"|x2 in mm",
                "0 0 NaN 1|\"NaN\"|x2 in mm",
                "0 0 1e99 1|\"1e99\"|x2 in mm",
                "0x10 0 1 1|\"0x10\"|x1 in mm"
            })
    void aBrokenWallNamesFileLineFoundAndExpected(String wall, String found, String expected) {
        WorldFormatException fault = fault("2D-Map", "LINES", "0 0 1 1", wall);
        assertEquals("test.map:4: found " + found + ", expected " + expected, fault.getMessage());
        assertEquals(4, fault.line());
    }

    @Test
    void aPointTakesTwoNumbersOrAThirdForReflectance() throws Exception {
        assertEquals(
                2, read("2D-Map", "DATA", "1 2", "3 4 33").items(Point.class).size());
        assertTrue(fault("2D-Map", "DATA", "1").getMessage().contains("y in mm"));
        assertTrue(fault("2D-Map", "DATA", "1 2 3 4").getMessage().contains("the end of the line"));
    }

    @Test
    void aFileThatIsNoMapIsRefusedAtItsFirstLine() {
        assertEquals(1, fault("<html>").line());
        assertTrue(fault("<html>").getMessage().contains("\"2D-Map\""));
        assertThrows(WorldFormatException.class, () -> MapReader.read("test.map", ""));
    }

    @Test
    void numbersInTheHeaderAreRefused() {
        assertTrue(fault("2D-Map", "0 0 1 1").getMessage().contains("LINES or DATA"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "RobotHome x 0 0 \"\" ICON \"\"",
                "RobotHome 0 0",
                "RobotHome 0 0 0 \"\" ICON \"open",
                "RobotHome 0 0 0 \"\" ICON",
                "RobotHome 0 0 0 \"\" ICON \"\" 1 2 3",
                "RobotHome 0 0 0 \"\" ICON \"\" 1 2 3 4 5",
                "ForbiddenArea 0 0 0 \"\" ICON \"\"",
                "ForbiddenLine 0 0 0 \"\" ICON \"\"",
                "Sim.BoxObstacle 0 0 0 \"\" ICON \"\"",
                "Sim.Treadmill 0 0 0 \"\" ICON \"v=100\"",
                "Sim.Treadmill 0 0 0 \"\" ICON \"fast\" 0 0 1 1",
                "Sim.Treadmill 0 0 0 \"\" ICON \"v=1e9\" 0 0 1 1",
                "Sim.Treadmill 0 0 0 \"\" ICON \"v=NaN\" 0 0 1 1"
            })
    void aBrokenCairnThatMattersIsRefusedWithItsLine(String cairn) {
        assertEquals(
                3, fault("2D-Map", "NumLines: 0", "Cairn: " + cairn, "LINES").line());
    }

    @Test
    void latinOneNamesSurvive() {
        assertEquals("Caf\u00e9", WorldReader.decode(new byte[] {'C', 'a', 'f', (byte) 0xE9}));
        assertEquals("Caf\u00e9", WorldReader.decode(new byte[] {'C', 'a', 'f', (byte) 0xC3, (byte) 0xA9}));
        assertEquals("2D", WorldReader.decode(new byte[] {(byte) 0xEF, (byte) 0xBB, (byte) 0xBF, '2', 'D'}));
    }
}
