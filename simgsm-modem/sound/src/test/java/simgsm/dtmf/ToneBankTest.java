package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;

class ToneBankTest {
    /** The sum in the class's Javadoc, term by term, in double precision. */
    private static double[] direct(short[] x, int middle, double hertz) {
        double real = 0;
        double imaginary = 0;
        for (int i = -20; i < 20; i++) {
            double weight = (20 - Math.abs(i + 0.5)) / 20 / 10;
            double angle = 2 * Math.PI * hertz / 8000 * (i + 0.5);
            real += weight * x[middle + i] * Math.cos(angle);
            imaginary -= weight * x[middle + i] * Math.sin(angle);
        }
        return new double[] {real, imaginary};
    }

    @Test
    void everyHopEqualsTheDirectSumWhateverTheSignalsPhase() {
        for (int degrees = 0; degrees < 360; degrees += 30) {
            for (double hertz : new double[] {697, 941 * 1.018, 1209, 1633 * 0.982, 50, 3900}) {
                short[] samples = new short[20 + 20 * 13];
                for (int i = 0; i < samples.length; i++) {
                    samples[i] = (short)
                            Math.rint(12_000 * Math.sin(2 * Math.PI * hertz * i / 8000 + Math.toRadians(degrees)));
                }
                ToneBank bank = new ToneBank();
                bank.accept(samples, 20, 13);
                for (int k = 0; k < ToneBank.TONES; k++) {
                    for (int hop = 0; hop < 13; hop++) {
                        double[] expected = direct(samples, 20 + 20 * hop, ToneBank.HERTZ[k]);
                        assertEquals(expected[0], bank.real[k][ToneBank.HISTORY + hop], 0.05);
                        assertEquals(expected[1], bank.imaginary[k][ToneBank.HISTORY + hop], 0.05);
                    }
                }
            }
        }
    }

    @Test
    void aToneShowsItsPeakAndLeaksAsDocumented() {
        short[] samples = new short[20 + 20 * 40];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = (short) Math.rint(10_000 * Math.sin(2 * Math.PI * 770 * i / 8000));
        }
        ToneBank bank = new ToneBank();
        bank.accept(samples, 20, 40);
        double own = 0;
        double next = 0;
        for (int hop = 0; hop < 40; hop++) {
            own += Math.sqrt(bank.power(1, ToneBank.HISTORY + hop)) / 40;
            next += Math.sqrt(bank.power(2, ToneBank.HISTORY + hop)) / 40;
        }
        assertEquals(10_000, own, 50);
        assertEquals(10_000 * ToneBank.leakBetween(1, 2), next, 100);
        assertEquals(0, ToneBank.leak(400), 1e-9);
    }

    @Test
    void sumsDoNotDependOnHowManyHopsAreTakenAtATime() {
        Random random = new Random(5);
        short[] samples = new short[20 + 20 * ToneBank.MOST_HOPS];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = (short) random.nextInt();
        }
        ToneBank together = new ToneBank();
        together.accept(samples, 20, ToneBank.MOST_HOPS);
        ToneBank single = new ToneBank();
        for (int hop = 0; hop < ToneBank.MOST_HOPS; hop++) {
            single.accept(samples, 20 + 20 * hop, 1);
            single.shift(1);
        }
        together.shift(ToneBank.MOST_HOPS);
        for (int k = 0; k < ToneBank.TONES; k++) {
            float[] expected = java.util.Arrays.copyOf(together.real[k], ToneBank.HISTORY);
            assertArrayEquals(expected, java.util.Arrays.copyOf(single.real[k], ToneBank.HISTORY), "tone " + k);
        }
    }
}
