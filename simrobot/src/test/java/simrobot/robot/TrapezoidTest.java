package simrobot.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TrapezoidTest {
    private static final double STEP = 0.01;

    @Test
    void aLongWayIsARampACruiseAndARamp() {
        // 0.5 m/s after 0.5/0.3 s on 0.41667 m; twice that, and the rest at 0.5 m/s
        assertEquals(2 * 0.5 / 0.3 + (10 - 0.5 * 0.5 / 0.3) / 0.5, Trapezoid.FORWARD.seconds(10), 1e-12);
    }

    @Test
    void aShortWayIsATriangle() {
        assertEquals(2 * Math.sqrt(0.2 / 0.3), Trapezoid.FORWARD.seconds(0.2), 1e-12);
    }

    @Test
    void bothFormulasAgreeWhereTheCruiseVanishes() {
        double way = 0.5 * 0.5 / 0.3;
        assertEquals(Trapezoid.FORWARD.seconds(way - 1e-9), Trapezoid.FORWARD.seconds(way + 1e-9), 1e-6);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 0.01, 0.2, 0.8333, 0.8334, 1, 3.33, 99.99})
    void stepsAddUpToTheWayInTheNominalTimeAndKeepTheLimits(double way) {
        double done = 0;
        double speed = 0;
        int steps = 0;
        do {
            Trapezoid.Step stretch = Trapezoid.FORWARD.towards(way - done, speed, STEP);
            assertTrue(stretch.distance() >= 0);
            assertTrue(stretch.speed() <= 0.5 + 1e-12);
            assertTrue(Math.abs(stretch.speed() - speed) <= 0.3 * STEP * 1.002 + 1e-12, "at step " + steps);
            assertTrue(stretch.distance() <= 0.5 * STEP + 1e-12);
            done += stretch.distance();
            speed = stretch.speed();
            steps++;
        } while (speed > 0);
        assertEquals(way, done, 1e-9);
        assertEquals(Trapezoid.FORWARD.seconds(way), steps * STEP, STEP + 1e-6);
    }

    @Test
    void theStepsLengthDoesNotMatter() {
        assertEquals(placeAfter(1.5, 1), placeAfter(1.5, 150), 1e-9);
        assertEquals(placeAfter(1.5, 3), placeAfter(1.5, 1000), 1e-9);
    }

    private static double placeAfter(double seconds, int steps) {
        double done = 0;
        double speed = 0;
        for (int i = 0; i < steps; i++) {
            Trapezoid.Step stretch = Trapezoid.FORWARD.towards(0.3 - done, speed, seconds / steps);
            done += stretch.distance();
            speed = stretch.speed();
        }
        return done;
    }

    @Test
    void brakingTakesTheSquareOfTheSpeedOverTwiceTheDeceleration() {
        double way = 0;
        double speed = 0.5;
        int steps = 0;
        while (speed > 0) {
            Trapezoid.Step stretch = Trapezoid.FORWARD.brake(speed, STEP);
            way += stretch.distance();
            speed = stretch.speed();
            steps++;
        }
        assertEquals(0.5 * 0.5 / 0.6, way, 1e-12);
        assertEquals(167, steps);
    }

    @Test
    void aGoalTooNearToStopAtIsOverrunWithTheUsualDeceleration() {
        Trapezoid.Step stretch = Trapezoid.FORWARD.towards(0.01, 0.5, STEP);
        assertEquals(0.5 - 0.3 * STEP, stretch.speed(), 1e-12);
        assertEquals(0.497, Trapezoid.FORWARD.towards(-1, 0.5, STEP).speed(), 1e-12);
        assertEquals(0, Trapezoid.FORWARD.towards(-1, 0, STEP).distance());
    }

    @Test
    void limitsAreAboveZero() {
        assertThrows(IllegalArgumentException.class, () -> new Trapezoid(0, 1));
        assertThrows(IllegalArgumentException.class, () -> new Trapezoid(1, -1));
    }
}
