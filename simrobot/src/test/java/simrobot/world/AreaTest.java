package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AreaTest {
    private static final double TOLERANCE = 1e-9;
    private static final Area UPRIGHT = new Area(1, 2, 4, 3, 0);

    private static void assertPlace(double x, double y, Position place) {
        assertEquals(x, place.xMeters(), TOLERANCE);
        assertEquals(y, place.yMeters(), TOLERANCE);
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void everyNumberIsFinite(double wrong) {
        assertThrows(IllegalArgumentException.class, () -> new Area(wrong, 0, 1, 1, 0));
        assertThrows(IllegalArgumentException.class, () -> new Area(0, wrong, 1, 1, 0));
        assertThrows(IllegalArgumentException.class, () -> new Area(0, 0, wrong, 1, 0));
        assertThrows(IllegalArgumentException.class, () -> new Area(0, 0, 1, wrong, 0));
        assertThrows(IllegalArgumentException.class, () -> new Area(0, 0, 1, 1, wrong));
    }

    @Test
    void theFirstCornerIsNotBeyondTheSecond() {
        assertThrows(IllegalArgumentException.class, () -> new Area(1.1, 0, 1, 1, 0));
        assertThrows(IllegalArgumentException.class, () -> new Area(0, 1.1, 1, 1, 0));
        assertEquals(new Area(1, 2, 4, 3, 0.5), Area.between(4, 2, 1, 3, 0.5));
        assertEquals(new Area(1, 2, 1, 2, 0), Area.between(1, 2, 1, 2, 0));
    }

    @Test
    void theBorderBelongsToTheArea() {
        assertTrue(UPRIGHT.contains(1, 2) && UPRIGHT.contains(4, 3));
        assertFalse(UPRIGHT.contains(Math.nextDown(1.0), 2.5));
        assertFalse(UPRIGHT.contains(Math.nextUp(4.0), 2.5));
        assertFalse(UPRIGHT.contains(2, Math.nextDown(2.0)));
        assertFalse(UPRIGHT.contains(2, Math.nextUp(3.0)));
    }

    @Test
    void theTurnIsAboutTheOriginOfTheMap() {
        Area turned = new Area(1, 2, 4, 3, Math.PI / 2);
        List<Position> corners = turned.corners();
        assertPlace(-2, 1, corners.get(0));
        assertPlace(-2, 4, corners.get(1));
        assertPlace(-3, 4, corners.get(2));
        assertPlace(-3, 1, corners.get(3));
        assertPlace(-2.5, 2.5, turned.center());
        assertPlace(2.5, 2.5, UPRIGHT.center());
        assertTrue(turned.contains(-2.5, 3.5));
        assertFalse(turned.contains(3.5, 2.5));
    }

    @Test
    void aTurnedAreaContainsThePlacesBetweenItsCorners() {
        Random random = new Random(3);
        for (int i = 0; i < 500; i++) {
            Area area = Area.between(
                    random.nextGaussian(),
                    random.nextGaussian(),
                    random.nextGaussian(),
                    random.nextGaussian(),
                    random.nextGaussian() * 3);
            List<Position> corners = area.corners();
            double s = random.nextDouble() * 1.4 - 0.2;
            double t = random.nextDouble() * 1.4 - 0.2;
            Position origin = corners.get(0);
            Position along = corners.get(1);
            Position across = corners.get(3);
            double x = origin.xMeters()
                    + s * (along.xMeters() - origin.xMeters())
                    + t * (across.xMeters() - origin.xMeters());
            double y = origin.yMeters()
                    + s * (along.yMeters() - origin.yMeters())
                    + t * (across.yMeters() - origin.yMeters());
            assertEquals(s >= 0 && s <= 1 && t >= 0 && t <= 1, area.contains(x, y), area + " " + s + " " + t);
            Position local = area.local(x, y);
            assertPlace(
                    area.minXMeters() + s * (area.maxXMeters() - area.minXMeters()),
                    area.minYMeters() + t * (area.maxYMeters() - area.minYMeters()),
                    local);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.7, -2, Math.PI})
    void movingShiftsEachCornerInTheDirectionsOfTheFloor(double radians) {
        Area area = new Area(1, 2, 4, 3, radians);
        Area moved = area.movedBy(0.3, -1.1);
        for (int i = 0; i < 4; i++) {
            Position before = area.corners().get(i);
            assertPlace(
                    before.xMeters() + 0.3,
                    before.yMeters() - 1.1,
                    moved.corners().get(i));
        }
        assertEquals(radians, moved.rotationRadians());
    }

    @Test
    void movingLeavesNoFloatingPointErrorOfDecimals() {
        assertEquals(new Area(0.3, 0.3, 0.4, 0.4, 0), new Area(0.1, 0.1, 0.2, 0.2, 0).movedBy(0.2, 0.2));
        double thirds = 1 / 3.0;
        assertEquals(
                new Area(thirds, 1, 2, 3, 0), new Area(thirds, 0, 2, 2, 0).movedBy(0, 1), "no change, no rounding");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void aPulledCornerMovesAndTheOppositeOneStays(int corner) {
        for (double radians : new double[] {0, 0.7}) {
            Area area = new Area(1, 2, 4, 3, radians);
            double x = corner % 3 == 0 ? -1 : 6;
            double y = corner < 2 ? -2 : 7;
            Position to = Area.between(x, y, x, y, radians).corners().get(0);
            Area pulled = area.pulled(corner, to);
            assertPlace(to.xMeters(), to.yMeters(), pulled.corners().get(corner));
            Position opposite = area.corners().get((corner + 2) % 4);
            assertPlace(opposite.xMeters(), opposite.yMeters(), pulled.corners().get((corner + 2) % 4));
            assertEquals(radians, pulled.rotationRadians());
        }
    }

    @Test
    void theSidesJoinTheCornersAnticlockwise() {
        assertEquals(
                List.of(
                        new Segment(1, 2, 4, 2),
                        new Segment(4, 2, 4, 3),
                        new Segment(4, 3, 1, 3),
                        new Segment(1, 3, 1, 2)),
                UPRIGHT.sides());
    }
}
