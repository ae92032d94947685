package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DistancesTest {
    private static final double MISS = Double.POSITIVE_INFINITY;

    @ParameterizedTest
    @CsvSource({
        "3, 7, 4", // before the middle
        "1, 3, 0", // on it
        "-2, -1, 5", // beside the first end
        "8, 7, 5", // beside the second end
    })
    void theNearestPlaceOfASegmentIsOnItOrAnEnd(double x, double y, double distance) {
        assertEquals(distance, Distances.toSegment(x, y, 1, 3, 5, 3), 1e-12);
        assertEquals(distance, Distances.toSegment(x, y, 5, 3, 1, 3), 1e-12);
        assertEquals(distance, Distances.toSegment(y, x, 3, 5, 3, 1), 1e-12);
    }

    @Test
    void aSegmentWithoutLengthIsAPoint() {
        assertEquals(5, Distances.toSegment(4, 5, 1, 1, 1, 1), 1e-12);
    }

    /** A ray from (1, 1) in the direction (0.6, 0.8) meets (4, 5) after 5 m. */
    @ParameterizedTest
    @CsvSource({
        "0, 8, 8, 2, 5", // across, from the left and from the right
        "8, 2, 0, 8, 5",
        "3.999, 5, 9, 5, 5", // it ends just beyond the ray
        "-9, 5, 4.001, 5, 5",
        "4, 2, 4, 9, 5",
        "4.001, 5, 9, 5, Infinity", // it ends beside the ray
        "-9, 5, 3.999, 5, Infinity",
        "-2, -3, 9, -3, Infinity", // behind
        "-2, -3, -2, 9, Infinity",
        "4, 5, 7, 9, Infinity", // along the ray
    })
    void aRayMeetsASegment(double x1, double y1, double x2, double y2, double distance) {
        assertEquals(distance, Distances.alongRay(1, 1, 0.6, 0.8, x1, y1, x2, y2), 1e-12);
    }

    @Test
    void theEndsOfASegmentAndTheBeginningOfTheRayCount() {
        assertEquals(3, Distances.alongRay(1, 1, 1, 0, 4, 1, 4, 9));
        assertEquals(3, Distances.alongRay(1, 1, 1, 0, 4, -9, 4, 1));
        assertEquals(3, Distances.alongRay(1, 1, 1, 0, 4, 1, 4, -9));
        assertEquals(3, Distances.alongRay(1, 1, 0, 1, 1, 4, 9, 4));
        assertEquals(0, Distances.alongRay(1, 1, 1, 0, 1, -9, 1, 9), 1e-15);
        assertEquals(0, Distances.alongRay(1, 1, 1, 0, 1, 9, 1, -9), 1e-15);
        assertEquals(MISS, Distances.alongRay(1, 1, 1, 0, 0.999, -9, 0.999, 9));
        assertEquals(MISS, Distances.alongRay(1, 1, 1, 0, 4, 1.001, 4, 9));
    }

    /** The same ray and a disc of 0.5 m. */
    @ParameterizedTest
    @CsvSource({
        "4, 5, 4.5", // towards the middle
        "1.2, 1.3, 0", // from inside
        "-2, -3, Infinity", // behind
    })
    void aRayMeetsTheRimOfADisc(double px, double py, double distance) {
        assertEquals(distance, Distances.alongRayToDisc(1, 1, 0.6, 0.8, px, py, 0.5), 1e-12);
    }

    @ParameterizedTest
    @CsvSource({"0.3, 4.6", "-0.3, 4.6", "0.4, 4.7", "0.499, 4.968", "0.501, Infinity", "-0.501, Infinity"})
    void aRayMeetsADiscBesideItLater(double beside, double distance) {
        double px = 1 + 5 * 0.6 + beside * 0.8;
        double py = 1 + 5 * 0.8 - beside * 0.6;
        assertEquals(distance, Distances.alongRayToDisc(1, 1, 0.6, 0.8, px, py, 0.5), 5e-4);
    }

    @Test
    void aRayFromTheRimOutwardsMeetsNothing() {
        assertEquals(0, Distances.alongRayToDisc(0, 0, 1, 0, -0.5, 0, 0.5));
        assertEquals(MISS, Distances.alongRayToDisc(0, 0, 1, 0, -0.5001, 0, 0.5));
        assertEquals(MISS, Distances.alongRayToDisc(0, 0, 1, 0, 0, 0.7, 0.5));
    }
}
