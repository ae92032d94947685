package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What can be moved and changed in a world. */
class WorldItemTest {
    private static final Area AREA = new Area(1, 2, 4, 3, 0);
    private static final Area MOVED_AREA = new Area(1.5, 1, 4.5, 2, 0);
    private static final Area PULLED_AREA = new Area(0, 0, 4, 3, 0);

    @Test
    void aWallMovesAndItsEndsCanBePulled() {
        Segment wall = new Segment(1, 2, 3, 4);
        assertEquals(List.of(new Position(1, 2), new Position(3, 4)), wall.handles());
        assertEquals(new Segment(1.5, 1, 3.5, 3), wall.movedBy(0.5, -1));
        assertEquals(new Segment(7, 8, 3, 4), wall.pulled(0, new Position(7, 8)));
        assertEquals(new Segment(1, 2, 7, 8), wall.pulled(1, new Position(7, 8)));
    }

    @Test
    void furnitureMovesAndItsCornersCanBePulled() {
        Box box = new Box("desk", AREA);
        assertEquals(AREA.corners(), box.handles());
        assertEquals(new Box("desk", MOVED_AREA), box.movedBy(0.5, -1));
        assertEquals(new Box("desk", PULLED_AREA), box.pulled(0, new Position(0, 0)));
    }

    @Test
    void aBeltMovesAndItsCornersCanBePulled() {
        Treadmill belt = new Treadmill(AREA, 0.5, 1);
        assertEquals(AREA.corners(), belt.handles());
        assertEquals(new Treadmill(MOVED_AREA, 0.5, 1), belt.movedBy(0.5, -1));
        assertEquals(new Treadmill(PULLED_AREA, 0.5, 1), belt.pulled(0, new Position(0, 0)));
    }

    @Test
    void aBeltRunsAlongItsDirection() {
        Treadmill belt = new Treadmill(AREA, -0.5, Math.PI / 6);
        assertEquals(-0.5 * Math.sqrt(0.75), belt.velocityX(), 1e-12);
        assertEquals(-0.25, belt.velocityY(), 1e-12);
    }

    @Test
    void aHomeMovesWithItsAreaAndItsHeadingCanBePulled() {
        Home home = new Home("A", new Position(2, 2.5), Math.PI / 2, Optional.of(AREA));
        assertEquals(
                new Home("A", new Position(2.5, 1.5), Math.PI / 2, Optional.of(MOVED_AREA)), home.movedBy(0.5, -1));
        Position handle = home.handles().get(0);
        assertEquals(2, handle.xMeters(), 1e-12);
        assertEquals(3.1, handle.yMeters(), 1e-12);
        assertEquals(
                2.6,
                new Home("B", new Position(2, 2.5), 0, Optional.empty())
                        .handles()
                        .get(0)
                        .xMeters());
        assertEquals(
                new Home("A", new Position(2, 2.5), Math.toRadians(127), Optional.empty()),
                home.pulled(0, new Position(2 - 3.004, 2.5 + 4)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY})
    void everyNumberIsFinite(double wrong) {
        assertThrows(IllegalArgumentException.class, () -> new Segment(wrong, 0, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new Segment(0, wrong, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new Segment(0, 0, wrong, 0));
        assertThrows(IllegalArgumentException.class, () -> new Segment(0, 0, 0, wrong));
        assertThrows(IllegalArgumentException.class, () -> new Position(wrong, 0));
        assertThrows(IllegalArgumentException.class, () -> new Position(0, wrong));
        assertThrows(IllegalArgumentException.class, () -> new Treadmill(AREA, wrong, 0));
        assertThrows(IllegalArgumentException.class, () -> new Treadmill(AREA, 0, wrong));
        Position origin = new Position(0, 0);
        assertThrows(IllegalArgumentException.class, () -> new Goal("Goal", "", origin, wrong));
        assertThrows(IllegalArgumentException.class, () -> new Home("", origin, wrong, Optional.empty()));
    }
}
