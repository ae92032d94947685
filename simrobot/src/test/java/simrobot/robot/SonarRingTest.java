package simrobot.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SonarRingTest {
    /** Front sonars 0..7 mirror each other left to right, rear sonars 8..15 likewise. */
    @Test
    void leftMirrorsRight() {
        for (int i = 0; i < 4; i++) {
            assertMirrored(i, 7 - i);
            assertMirrored(8 + i, 15 - i);
        }
    }

    private static void assertMirrored(int left, int right) {
        assertEquals(SonarRing.mountX(left), SonarRing.mountX(right), "x of " + left);
        assertEquals(SonarRing.mountY(left), -SonarRing.mountY(right), "y of " + left);
        assertEquals(
                0,
                Math.IEEEremainder(SonarRing.directionRadians(left) + SonarRing.directionRadians(right), 2 * Math.PI),
                1e-12);
    }

    /** The rear array is the front one turned by 180 degrees about a place 44.5 mm behind the centre of rotation. */
    @Test
    void rearMirrorsFront() {
        for (int i = 0; i < 8; i++) {
            assertEquals(-0.089, SonarRing.mountX(i) + SonarRing.mountX(8 + i), 0.0011, "x of " + i);
            assertEquals(-SonarRing.mountY(i), SonarRing.mountY(8 + i), "y of " + i);
        }
    }

    @Test
    void everySonarLooksOutwards() {
        for (int i = 0; i < SonarRing.COUNT; i++) {
            double x = SonarRing.mountX(i) - Pioneer2Dx.BODY_MIDDLE_X_METERS;
            double outwards = x * Math.cos(SonarRing.directionRadians(i))
                    + SonarRing.mountY(i) * Math.sin(SonarRing.directionRadians(i));
            assertTrue(outwards > 0.1, "sonar " + i);
        }
    }

    @Test
    void theBodyIsAConvexOctagonOfTheRightSize() {
        double[][] corners = Pioneer2Dx.octagon();
        double length = 0;
        double width = 0;
        for (int i = 0; i < 8; i++) {
            double[] a = corners[i];
            double[] b = corners[(i + 1) % 8];
            double[] c = corners[(i + 2) % 8];
            double turn = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
            assertTrue(turn > 0, "corner " + i);
            assertEquals(a[1], -corners[7 - i][1], 1e-15);
            length = Math.max(length, Math.abs(a[0] - Pioneer2Dx.BODY_MIDDLE_X_METERS) * 2);
            width = Math.max(width, a[1] * 2);
        }
        assertEquals(0.44, length, 1e-12);
        assertEquals(0.38, width, 1e-12);
    }
}
