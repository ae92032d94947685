package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import simgsm.tone.ToneLevel;

class ResidualSpectrumTest {
    private static final int ONSET = 400;
    private static final int END = 700;

    private static ResidualSpectrum of(Tape tape) {
        ResidualSpectrum spectrum = new ResidualSpectrum();
        spectrum.measure(tape.samples(), END, ONSET, 770, 1336);
        return spectrum;
    }

    /** A tape on which 770 and 1336 Hz begin at ONSET. */
    private static Tape key() {
        Tape tape = new Tape(8);
        tape.silence(ONSET / 8.0);
        return tape.digits("5");
    }

    @Test
    void aKeyAloneLeavesNothing() {
        ResidualSpectrum spectrum = of(key());
        double tone = Math.pow(ToneLevel.amplitude(-10), 2);
        assertTrue(spectrum.rest < 2e-3 * tone, spectrum.rest / tone + " of a tone");
        assertEquals(0, spectrum.restBefore, 1);
        assertEquals(0, spectrum.rowBefore + spectrum.columnBefore, 1);
    }

    @Test
    void aThirdToneIsFoundAtItsPlaceWithItsPower() {
        ResidualSpectrum spectrum = of(key().hum(2000, -20));
        assertEquals(2000, spectrum.lineHertz, 16);
        double decibels = 10 * Math.log10(spectrum.line / Math.pow(ToneLevel.amplitude(-20), 2));
        assertEquals(0, decibels, 1.5);
    }

    @Test
    void thePitchOfAVoiceIsFoundBelowDialTones() {
        double pitch = of(key().hum(150, -20)).pitch;
        assertEquals(0, 10 * Math.log10(pitch / Math.pow(ToneLevel.amplitude(-20), 2)), 2);
        double dialTone = of(key().hum(440, -20)).pitch;
        assertTrue(dialTone < 0.05 * pitch, dialTone / pitch + " of the pitch");
    }

    @Test
    void noiseIsEvenAndTheSameBefore() {
        double evenness = 0;
        double ratio = 0;
        for (int seed = 0; seed < 30; seed++) {
            Tape tape = new Tape(seed);
            tape.silence(ONSET / 8.0);
            ResidualSpectrum spectrum = of(tape.digits("5").noise(-20));
            assertTrue(spectrum.evenness() > 0.4, "seed " + seed);
            evenness += spectrum.evenness() / 30;
            ratio += spectrum.rest / spectrum.restBefore / 30;
        }
        assertEquals(0.63, evenness, 0.08);
        assertEquals(1, ratio, 0.2);
    }

    @Test
    void aVoicesHarmonicsAreUneven() {
        Tape tape = key();
        for (int h = 2; h < 12; h++) {
            tape.hum(300 * h, -22);
        }
        ResidualSpectrum spectrum = of(tape);
        assertTrue(spectrum.evenness() < 0.3, "evenness " + spectrum.evenness());
    }
}
