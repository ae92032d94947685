package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

class ToneVetoTest {
    /** A key as clear as can be, of which one thing is changed. */
    private static ToneEvidence but(Consumer<ToneEvidence> change) {
        ToneEvidence evidence = new ToneEvidence();
        evidence.fit = new ToneFit();
        evidence.fit.hertz[0] = 770;
        evidence.fit.hertz[1] = 1336;
        evidence.fit.sinceOnset = 11;
        evidence.coherence = 0.99;
        evidence.ripple = 1.02;
        evidence.line = -50;
        change.accept(evidence);
        return evidence;
    }

    private static void only(ToneVeto veto, Consumer<ToneEvidence> change) {
        for (ToneVeto each : ToneVeto.values()) {
            assertEquals(each == veto, each.holds(but(change)), each.toString());
        }
    }

    @Test
    void nothingSpeaksAgainstAClearKey() {
        assertFalse(ToneVeto.any(but(evidence -> {}), false));
        assertFalse(ToneVeto.any(but(evidence -> {}), true));
    }

    @Test
    void tonesThatWanderInPhaseAreNoKeys() {
        only(ToneVeto.INCOHERENT, evidence -> {
            evidence.coherence = 0.3;
            evidence.ripple = 3;
            evidence.fit.sinceOnset = 20;
        });
    }

    @Test
    void tonesThatNobodyHeardBeginAreNoKeys() {
        only(ToneVeto.BEGAN_UNSEEN, evidence -> {
            evidence.fit.open = true;
            evidence.fit.sinceOnset = ToneFit.SPAN - 1;
        });
    }

    @Test
    void inNoiseAKeyMustSoundALittleLonger() {
        only(ToneVeto.TOO_EARLY_IN_NOISE, evidence -> {
            evidence.coherence = 0.7;
            evidence.ripple = 2;
        });
        assertFalse(ToneVeto.TOO_EARLY_IN_NOISE.holds(but(evidence -> {
            evidence.coherence = 0.7;
            evidence.fit.sinceOnset = 12.5;
        })));
    }

    @Test
    void tonesFarFromOneLevelAreNoKeys() {
        only(ToneVeto.TWISTED, evidence -> evidence.twist = 14);
        only(ToneVeto.TWISTED, evidence -> evidence.twist = -14);
    }

    @Test
    void anOctaveIsNoKey() {
        only(ToneVeto.OCTAVE, evidence -> evidence.fit.hertz[1] = 1541);
    }

    @Test
    void aToneWithItsOvertoneIsNoKey() {
        only(ToneVeto.OVERTONE, evidence -> {
            evidence.line = -8;
            evidence.residue.lineHertz = 1531;
        });
    }

    @Test
    void faintTonesInADinThatLiesMostlyBesideTheirBandAreNoKeys() {
        only(ToneVeto.FAINT_IN_DIN, evidence -> {
            evidence.weakerDbm0 = -41;
            evidence.share = 0.6;
            evidence.shareOfAll = 0.1;
        });
    }

    @Test
    void tonesThatGlideAreNoKeys() {
        only(ToneVeto.GLIDING, evidence -> evidence.coherence = 0.94);
    }

    @Test
    void theThirdAndSeventhHarmonicOfAVoiceAreNoKeyButAAloneIs() {
        assertEquals("", heard(true));
        assertEquals("A", heard(false));
    }

    /** 696 and 1624 Hz, which is A within its limits, with or without the rest of a voice at 232 Hz. */
    private static String heard(boolean voice) {
        Tape tape = new Tape(3);
        tape.silence(100);
        tape.rowError = 696.0 / 697 - 1;
        tape.columnError = 1624.0 / 1633 - 1;
        tape.digits("A");
        for (int h : new int[] {2, 4, 5, 6, 8, 9}) {
            if (voice) {
                double[] line = Voices.atLevel(Voices.cadence(tape.random, 640, new double[] {232 * h}, 80), -28);
                for (int i = 0; i < line.length; i++) {
                    tape.sound[800 + i] += line[i];
                }
            }
        }
        assertTrue(tape.length() > 1440);
        return Bench.text(Bench.hear(tape.samples()));
    }
}
