package simgsm.cells.radio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;

class ShadowFieldTest {
    private static final double DEVIATION = 7;
    private static final double CORRELATION_METRES = 50;
    private static final int FIELDS = 40;
    private static final int PLACES = 2_000;

    /** Mean product of the values of two places that lie apart by so much, over many fields and places, in dB squared. */
    private static double covariance(double metresApart) {
        Random random = new Random(5);
        double sum = 0;
        for (int seed = 0; seed < FIELDS; seed++) {
            ShadowField field = new ShadowField(DEVIATION, CORRELATION_METRES, seed);
            for (int i = 0; i < PLACES; i++) {
                double x = random.nextDouble(20_000);
                double y = random.nextDouble(20_000);
                double direction = random.nextDouble(2 * Math.PI);
                sum += field.decibels(x, y)
                        * field.decibels(x + metresApart * Math.cos(direction), y + metresApart * Math.sin(direction));
            }
        }
        return sum / (FIELDS * PLACES);
    }

    @Test
    void theDeviationIsTheOneAskedFor() {
        assertEquals(DEVIATION, Math.sqrt(covariance(0)), 0.1);
    }

    @Test
    void theCorrelationFallsWithDistanceAsAnExponential() {
        for (double metres : new double[] {10, 25, 50, 100, 200}) {
            double expected = Math.exp(-metres / CORRELATION_METRES);
            assertEquals(expected, covariance(metres) / (DEVIATION * DEVIATION), 0.05, metres + " m");
        }
    }

    @Test
    void theValuesAreDistributedNormally() {
        Random random = new Random(6);
        int[] within = new int[3];
        for (int seed = 0; seed < FIELDS; seed++) {
            ShadowField field = new ShadowField(1, CORRELATION_METRES, seed);
            for (int i = 0; i < PLACES; i++) {
                double value = Math.abs(field.decibels(random.nextDouble(20_000), random.nextDouble(20_000)));
                for (int k = 0; k < within.length; k++) {
                    within[k] += value < k + 1 ? 1 : 0;
                }
            }
        }
        double all = FIELDS * PLACES;
        assertEquals(0.683, within[0] / all, 0.01);
        assertEquals(0.954, within[1] / all, 0.01);
        assertEquals(0.997, within[2] / all, 0.003);
    }

    @Test
    void theSameSeedGivesTheSameFieldAndAnotherSeedAnother() {
        ShadowField field = new ShadowField(DEVIATION, CORRELATION_METRES, 1);

        assertEquals(field.decibels(-300, 70), new ShadowField(DEVIATION, CORRELATION_METRES, 1).decibels(-300, 70));
        assertNotEquals(field.decibels(-300, 70), new ShadowField(DEVIATION, CORRELATION_METRES, 2).decibels(-300, 70));
    }

    @Test
    void withoutDeviationThereIsNoShadow() {
        assertEquals(0, new ShadowField(0, CORRELATION_METRES, 1).decibels(12, 34));
    }
}
