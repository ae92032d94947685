package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
    void theRaysBelongToTheCone() {
        Cone quarter = new Cone(1, 2, 1, 0, 0, -1);
        assertEquals(3, quarter.distanceToPoint(4, 2));
        assertEquals(3, quarter.distanceToPoint(1, -1));
        assertEquals(MISS, quarter.distanceToPoint(4, 2.001));
        assertEquals(MISS, quarter.distanceToPoint(0.999, -1));
        assertEquals(3, quarter.distanceToSegment(4, 2, 9, 2));
        assertEquals(3, quarter.distanceToSegment(9, 2, 4, 2));
        assertEquals(3, quarter.distanceToSegment(1, -1, 1, -9));
        assertEquals(3, quarter.distanceToSegment(4, 2, 4, 9));
        assertEquals(3, quarter.distanceToSegment(-9, -1, 1, -1));
        assertEquals(MISS, quarter.distanceToSegment(4, 2.001, 4, 9));
        assertEquals(MISS, quarter.distanceToSegment(-9, 2, 0.999, 2.1));
    }

    @Test
    void aWallThatPassesTheApexOutsideIsMissed() {
        Cone quarter = new Cone(0, 0, Math.PI / 4, Math.PI / 2);
        assertEquals(MISS, quarter.distanceToSegment(-3, 1, 1, -3));
        assertEquals(Math.sqrt(0.5), quarter.distanceToSegment(-3, 4, 4, -3), 1e-12);
        assertEquals(0, quarter.distanceToSegment(-3, 3, 3, -3), 1e-12);
    }

    @Test
    void aDiscMayBeInsideUnlessItIsBeyondARayOrTheReach() {
        double edge = Math.toRadians(10);
        double[] left = {2 * Math.cos(edge), 2 * Math.sin(edge)};
        double[] out = {-Math.sin(edge), Math.cos(edge)};
        for (int side : new int[] {1, -1}) {
            assertTrue(cone.mayHold(left[0] + 0.49 * out[0], side * (left[1] + 0.49 * out[1]), 0.5, 3));
            assertFalse(cone.mayHold(left[0] + 0.51 * out[0], side * (left[1] + 0.51 * out[1]), 0.5, 3));
        }
        assertTrue(cone.mayHold(3.5, 0, 0.5, 3));
        assertFalse(cone.mayHold(3.501, 0, 0.5, 3));
        assertFalse(cone.mayHold(-2, 0, 0.3, 3));
        Cone moved = new Cone(10, -20, 0, Math.toRadians(20));
        assertTrue(moved.mayHold(13.5, -20, 0.5, 3));
        assertFalse(moved.mayHold(13.501, -20, 0.5, 3));
        assertFalse(moved.mayHold(10, -17, 0.5, 3));
        Cone quarter = new Cone(0, 0, 1, 0, 0, -1);
        assertTrue(quarter.mayHold(2, 0.5, 0.5, 3));
        assertTrue(quarter.mayHold(-0.5, -2, 0.5, 3));
        assertFalse(quarter.mayHold(2, 0.501, 0.5, 3));
        assertFalse(quarter.mayHold(-0.501, -2, 0.5, 3));
    }

    @Test
    void aConeMustOpen() {
        assertThrows(IllegalArgumentException.class, () -> new Cone(0, 0, 0, 0));
        assertThrows(IllegalArgumentException.class, () -> new Cone(0, 0, 0, Math.PI));
    }
}
