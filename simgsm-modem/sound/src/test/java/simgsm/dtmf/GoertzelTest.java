package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class GoertzelTest {
    @Test
    void energyEqualsTheDirectFourierSumWhateverThePhase() {
        for (int degrees = 0; degrees < 360; degrees += 15) {
            for (double hertz : new double[] {697, 941, 1209, 1633, 25, 3990}) {
                short[] samples = sine(hertz * 1.01, 10_000, Math.toRadians(degrees), 205);
                double expected = directEnergy(samples, hertz);
                Goertzel goertzel = new Goertzel(hertz);
                goertzel.accept(samples, 0, 100);
                goertzel.accept(samples, 100, samples.length);
                assertEquals(expected, goertzel.energy(), 1e-7 * expected, hertz + " Hz at " + degrees + " degrees");
            }
        }
    }

    @Test
    void amplitudeIsThePeakOfASineOfWholePeriods() {
        Goertzel goertzel = new Goertzel(1000);
        goertzel.accept(sine(1000, 5000, 1, 400), 0, 400);
        assertEquals(5000, goertzel.amplitude(), 0.5);
        goertzel.reset();
        assertEquals(0, goertzel.amplitude());
        assertEquals(0, goertzel.energy());
    }

    private static short[] sine(double hertz, double amplitude, double phase, int count) {
        short[] samples = new short[count];
        for (int i = 0; i < count; i++) {
            samples[i] = (short) Math.rint(amplitude * Math.sin(2 * Math.PI * hertz * i / 8000 + phase));
        }
        return samples;
    }

    private static double directEnergy(short[] samples, double hertz) {
        double real = 0;
        double imaginary = 0;
        for (int i = 0; i < samples.length; i++) {
            real += samples[i] * Math.cos(2 * Math.PI * hertz * i / 8000);
            imaginary -= samples[i] * Math.sin(2 * Math.PI * hertz * i / 8000);
        }
        return real * real + imaginary * imaginary;
    }
}
