package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SaphiraReaderTest {
    private static World read(String... lines) throws WorldFormatException {
        return SaphiraReader.read("test.wld", String.join("\r\n", lines));
    }

    private static void assertSegment(double x1, double y1, double x2, double y2, Segment wall) {
        assertEquals(x1, wall.x1Meters(), 1e-12);
        assertEquals(y1, wall.y1Meters(), 1e-12);
        assertEquals(x2, wall.x2Meters(), 1e-12);
        assertEquals(y2, wall.y2Meters(), 1e-12);
    }

    @Test
    void fourNumbersAreAWallAndWidthAndHeightAreNone() throws Exception {
        World world = read("; a world", "width 10000", "height 8000", "0 0 1000 0 ; south");
        assertEquals(1, world.items(Segment.class).size());
        assertSegment(0, 0, 1, 0, world.items(Segment.class).get(0));
    }

    @Test
    void nestedFramesAreOffsetFirstThenTurned() throws Exception {
        World world = read(
                "push 1000 0 90", "0 0 500 0", "push 200 0 90", "0 0 100 0", "pop", "0 0 0 300", "pop", "0 0 10 0");
        assertSegment(1, 0, 1, 0.5, world.items(Segment.class).get(0));
        assertSegment(1, 0.2, 0.9, 0.2, world.items(Segment.class).get(1));
        assertSegment(1, 0, 0.7, 0, world.items(Segment.class).get(2));
        assertSegment(0, 0, 0.01, 0, world.items(Segment.class).get(3));
    }

    @Test
    void thePositionIsAHomeInItsFrame() throws Exception {
        Home home = read("push 1000 1000 90", "position 100 0 45", "pop")
                .items(Home.class)
                .get(0);
        assertEquals(1, home.position().xMeters(), 1e-12);
        assertEquals(1.1, home.position().yMeters(), 1e-12);
        assertEquals(Math.toRadians(135), home.headingRadians(), 1e-12);
    }

    @Test
    void faultsNameTheirLine() {
        assertFault(1, "width", "box 1 2 3 4");
        assertFault(2, "y2 in mm", "0 0 1 1", "0 0 1");
        assertFault(1, "pop without push", "pop");
        assertFault(2, "pop", "push 0 0 0", "0 0 1 1");
        assertFault(1, "0 or more", "width -5");
    }

    @Test
    void pushesWithoutEndAreRefused() {
        String[] lines = new String[SaphiraReader.MAX_DEPTH + 1];
        java.util.Arrays.fill(lines, "push 1 1 1");
        assertFault(lines.length, "at most", lines);
    }

    private static void assertFault(int line, String part, String... lines) {
        WorldFormatException fault = assertThrows(WorldFormatException.class, () -> read(lines));
        assertEquals(line, fault.line(), fault.getMessage());
        assertTrue(fault.getMessage().contains(part), fault.getMessage());
    }
}
