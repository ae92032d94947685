package simgsm.cells.radio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Bursts of lost frames against the durations of fades in the literature, and against a fading channel. */
class FrameLossesTest {
    private static final double MEGAHERTZ = 947;
    private static final double FRAME_SECONDS = 0.02;

    /** Rappaport, Wireless Communications, average fade durations: f = 200 Hz; thresholds of 0.01, 0.1 and 1 of the effective level. */
    @ParameterizedTest
    @CsvSource({"0.01, 19.9e-6, 0.1e-6", "0.1, 200e-6, 1e-6", "1, 3.43e-3, 0.01e-3"})
    void fadesLastAsLongAsTheLiteratureHasIt(double ratio, double seconds, double tolerance) {
        assertEquals(seconds, FrameLosses.fadeSeconds(-Math.expm1(-ratio * ratio), 200), tolerance);
    }

    @Test
    void theDopplerFrequencyFollowsTheSpeedAndIsThatOf3KilometresAnHourAtLeast() {
        assertEquals(43.9, FrameLosses.dopplerHertz(50 / 3.6, MEGAHERTZ), 0.05);
        assertEquals(2.63, FrameLosses.dopplerHertz(0, MEGAHERTZ), 0.005);
    }

    @ParameterizedTest
    @CsvSource({"0.06, 0", "0.06, 13.9", "0.06, 70", "0.2, 0", "0.2, 1.5", "0.5, 13.9", "0.9, 0"})
    void theShareOfLostFramesIsKeptAndTheirBurstsAreThoseOfTheFades(double share, double metresPerSecond) {
        FrameLosses losses = new FrameLosses(new SplittableRandom(5)::nextDouble);
        int frames = 500_000;
        int lost = 0;
        int bursts = 0;
        boolean wasLost = false;
        for (int i = 0; i < frames; i++) {
            boolean isLost = losses.next(share, metresPerSecond, MEGAHERTZ);
            lost += isLost ? 1 : 0;
            bursts += isLost && !wasLost ? 1 : 0;
            wasLost = isLost;
        }
        double expected = FrameLosses.burstFrames(share, FrameLosses.dopplerHertz(metresPerSecond, MEGAHERTZ));
        assertEquals(share, (double) lost / frames, 0.03 * share);
        assertEquals(expected, (double) lost / bursts, 0.04 * expected);
    }

    @Test
    void aSlowMobileLosesFramesInBurstsAndAFastOneByChance() {
        assertEquals(1.9, FrameLosses.burstFrames(0.06, FrameLosses.dopplerHertz(0, MEGAHERTZ)), 0.1);
        assertEquals(1 / 0.94, FrameLosses.burstFrames(0.06, FrameLosses.dopplerHertz(50 / 3.6, MEGAHERTZ)), 1e-9);
    }

    /** A channel of 64 waves from all sides (Clarke); frames are lost that begin below a level. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.2, 0.4})
    void burstsAreAsLongAsThoseOfAFadingChannel(double share) {
        double doppler = FrameLosses.dopplerHertz(0, MEGAHERTZ);
        double threshold = -Math.log1p(-share);
        int bursts = 0;
        int lost = 0;
        for (int seed = 0; seed < 40; seed++) {
            ClarkeChannel channel = new ClarkeChannel(seed, doppler);
            boolean wasLost = false;
            for (int i = 0; i < 5_000; i++) {
                boolean isLost = channel.power(i * FRAME_SECONDS) < threshold;
                lost += isLost ? 1 : 0;
                bursts += isLost && !wasLost ? 1 : 0;
                wasLost = isLost;
            }
        }
        double expected = FrameLosses.burstFrames(share, doppler);
        assertEquals(expected, (double) lost / bursts, 0.15 * expected);
    }

    private static final class ClarkeChannel {
        private static final int WAVES = 64;

        private final double[] phases = new double[WAVES];
        private final double[] frequencies = new double[WAVES];

        ClarkeChannel(long seed, double doppler) {
            SplittableRandom random = new SplittableRandom(seed);
            double turn = random.nextDouble();
            for (int i = 0; i < WAVES; i++) {
                phases[i] = 2 * Math.PI * random.nextDouble();
                frequencies[i] = 2 * Math.PI * doppler * Math.cos(2 * Math.PI * (i + turn) / WAVES);
            }
        }

        /** Relative to its mean. */
        double power(double seconds) {
            double real = 0;
            double imaginary = 0;
            for (int i = 0; i < WAVES; i++) {
                real += Math.cos(frequencies[i] * seconds + phases[i]);
                imaginary += Math.sin(frequencies[i] * seconds + phases[i]);
            }
            return (real * real + imaginary * imaginary) / WAVES;
        }
    }

    @Test
    void withoutLossesNoNumberIsDrawnAndWithoutSignalAllFramesAreLost() {
        FrameLosses losses = new FrameLosses(() -> {
            throw new AssertionError("drawn");
        });
        assertFalse(losses.next(0, 1, MEGAHERTZ));
        assertTrue(losses.next(1, 1, MEGAHERTZ));
        assertFalse(losses.next(0, 1, MEGAHERTZ));
    }
}
