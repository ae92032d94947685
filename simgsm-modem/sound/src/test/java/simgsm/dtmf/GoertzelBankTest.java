package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class GoertzelBankTest {
    private static final GoertzelBank.Window BLOCK = new GoertzelBank.Window(1);
    private static final GoertzelBank.Window THREE = new GoertzelBank.Window(0.25, 0.5, 0.25);

    private static short[] sine(double hertz, int degrees, int blocks) {
        short[] samples = new short[2 + 20 * blocks];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = (short) Math.rint(12_000 * Math.sin(2 * Math.PI * hertz * i / 8000 + Math.toRadians(degrees)));
        }
        return samples;
    }

    private static GoertzelBank hearing(short[] samples) {
        GoertzelBank bank = new GoertzelBank();
        for (int at = 2; at + 20 <= samples.length; at += 20) {
            bank.accept(samples, at);
        }
        return bank;
    }

    /** Sum of weighted differences of blocks, the newest first, turned about their middle, term by term. */
    private static double[] direct(short[] x, int block, double hertz, double... weights) {
        double real = 0;
        double imaginary = 0;
        for (int j = 0; j < weights.length; j++) {
            for (int i = 0; i < 20; i++) {
                int at = 2 + 20 * (block - j) + i;
                double angle = 2 * Math.PI * hertz / 8000 * (i - 9.5 + 20 * ((weights.length - 1) / 2.0 - j));
                real += weights[j] / 10 * (x[at] - x[at - 2]) * Math.cos(angle);
                imaginary -= weights[j] / 10 * (x[at] - x[at - 2]) * Math.sin(angle);
            }
        }
        return new double[] {real, imaginary};
    }

    @Test
    void windowsEqualTheDirectSumsWhateverTheSignalsPhase() {
        for (int degrees = 0; degrees < 360; degrees += 30) {
            for (double hertz : new double[] {697, 941 * 1.018, 1209, 1633 * 0.982, 50, 3900}) {
                short[] samples = sine(hertz, degrees, 13);
                GoertzelBank bank = hearing(samples);
                for (int k = 0; k < GoertzelBank.TONES; k++) {
                    for (int block = 2; block < 13; block++) {
                        bank.measure(k, block, BLOCK);
                        double[] one = direct(samples, block, GoertzelBank.HERTZ[k], 1);
                        assertArrayEquals(one, new double[] {bank.real, bank.imaginary}, 1e-6);
                        double square = bank.measure(k, block, THREE);
                        double[] three = direct(samples, block, GoertzelBank.HERTZ[k], 0.25, 0.5, 0.25);
                        assertArrayEquals(three, new double[] {bank.real, bank.imaginary}, 1e-6);
                        assertEquals(three[0] * three[0] + three[1] * three[1], square, 1e-6 * square + 1e-6);
                    }
                }
            }
        }
    }

    @Test
    void aToneShowsItsPeakTimesTheGainAndLeaksAsDocumented() {
        GoertzelBank bank = hearing(sine(770, 0, 40));
        double own = 0;
        double next = 0;
        for (int block = 4; block < 40; block++) {
            own += Math.sqrt(bank.measure(1, block, THREE)) / 36;
            next += Math.sqrt(bank.measure(2, block, THREE)) / 36;
        }
        double peak = 12_000 * GoertzelBank.gain(770);
        assertEquals(peak, own, 0.01 * peak);
        assertEquals(peak * TonePair.leak(82), next, 0.02 * peak);
        assertEquals(0, GoertzelBank.leak(400), 1e-9);
    }

    @Test
    void directCurrentIsNotHeard() {
        short[] samples = new short[202];
        java.util.Arrays.fill(samples, (short) 12_000);
        assertEquals(0, hearing(samples).measure(0, 9, THREE), 1e-9);
    }
}
