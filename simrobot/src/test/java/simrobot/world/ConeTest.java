package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class ConeTest {
    private static final double MISS = Double.POSITIVE_INFINITY;
    private final Cone cone = new Cone(0, 0, 0, Math.toRadians(20));

    @Test
    void aWallAcrossIsHeardAtItsNearestPlace() {
        assertEquals(2, cone.distanceToSegment(2, -5, 2, 5), 1e-12);
    }

    @Test
    void onlyThePartInsideCounts() {
        double edge = Math.toRadians(10);
        assertEquals(2 / Math.cos(edge), cone.distanceToSegment(2, 5, 2, 2 * Math.tan(edge)), 1e-12);
        assertEquals(MISS, cone.distanceToSegment(2, 5, 2, 2 * Math.tan(edge) + 1e-9));
    }

    @Test
    void whatLiesBehindIsNotHeard() {
        assertEquals(MISS, cone.distanceToSegment(-1, -5, -1, 5));
        assertEquals(MISS, cone.distanceToPoint(-1, 0));
    }

    @Test
    void aThinPostBetweenTheRaysIsHeard() {
        assertEquals(Math.hypot(3, 0.5), cone.distanceToPoint(3, 0.5), 1e-12);
        assertEquals(MISS, cone.distanceToPoint(3, 0.6));
    }

    @Test
    void aWallAlongTheAxisIsHeardAtItsNearEnd() {
        assertEquals(1, cone.distanceToSegment(1, 0, 4, 0), 1e-12);
    }

    @Test
    void aConeMustOpen() {
        assertThrows(IllegalArgumentException.class, () -> new Cone(0, 0, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new Cone(0, 0, 0, Math.PI));
    }
}
