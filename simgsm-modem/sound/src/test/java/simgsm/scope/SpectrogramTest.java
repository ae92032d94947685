package simgsm.scope;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SpectrogramTest {
    private static final double PEAK_OF_MINUS_10_DBM0 = 32768 * Math.pow(10, -13.14 / 20);

    @ParameterizedTest
    @ValueSource(doubles = {697, 770, 852, 941, 1209, 1336, 1477, 1633})
    void aToneIsHighestAtItsFrequencyAndHasItsLevelWithinTwoDecibels(double hertz) {
        Spectrogram spectrogram = new Spectrogram(sine(hertz, 2000));
        int middle = spectrogram.columns() / 2;
        double loudest = 0;
        for (double f = 300; f < 3000; f++) {
            loudest = spectrogram.dbm0(middle, f) > spectrogram.dbm0(middle, loudest) ? f : loudest;
        }

        assertEquals(hertz, loudest, Spectrogram.STEP_HERTZ / 2);
        assertEquals(-10, spectrogram.dbm0(middle, hertz), 2);
    }

    @Test
    void aToneBeginsWhereItBegins() {
        short[] samples = new short[4000];
        System.arraycopy(sine(1000, 2000), 0, samples, 2000, 2000);
        Spectrogram spectrogram = new Spectrogram(samples);
        int begin = 2000 / Spectrogram.HOP_SAMPLES;

        assertEquals(Spectrogram.FLOOR_DBM0, spectrogram.dbm0(begin - 5, 1000));
        assertTrue(spectrogram.dbm0(begin, 1000) > -12);
    }

    @Test
    void tooShortASoundHasNoSpectrum() {
        assertEquals(0, new Spectrogram(new short[255]).columns());
        assertEquals(1, new Spectrogram(new short[256]).columns());
        assertEquals(Spectrogram.FLOOR_DBM0, new Spectrogram(new short[256]).dbm0(0, 4000));
    }

    private static short[] sine(double hertz, int length) {
        short[] samples = new short[length];
        for (int i = 0; i < length; i++) {
            samples[i] = (short) Math.round(PEAK_OF_MINUS_10_DBM0 * Math.sin(2 * Math.PI * hertz * i / 8000));
        }
        return samples;
    }
}
