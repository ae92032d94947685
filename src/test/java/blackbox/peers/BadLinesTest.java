package blackbox.peers;

import static blackbox.peers.ToneReceiver.OURS;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Keys whose beginning is disturbed, keys behind codecs, and keys with echo: four receivers on the same samples. */
@Tag("peer")
class BadLinesTest {
    private static final int KEYS = 96;

    @TempDir
    Path folder;

    private Comparison comparison;

    @BeforeEach
    void peers() throws Exception {
        comparison = new Comparison(folder);
    }

    @Test
    void heldKeysWithDisturbedBeginningsAreHeardOnce() throws Exception {
        for (int millis : new int[] {20, 40, 60, 80, 100, 150}) {
            for (int decibels : new int[] {0, 6}) {
                Sound sound = new Sound(millis + decibels);
                sound.silence(300);
                for (int i = 0; i < KEYS; i++) {
                    int from = sound.key(500, 200);
                    sound.addNoise(-7 + decibels, from, from + 8 * millis);
                }
                comparison.add("first " + millis + " ms in noise, " + decibels + " dB", sound, Treatment.AS_IS);
            }
        }
        for (int millis : new int[] {30, 60, 100}) {
            Sound sound = new Sound(millis);
            sound.silence(300);
            for (int i = 0; i < KEYS; i++) {
                int from = sound.key(500, 200);
                sound.limit(-4, from, from + 8 * millis);
            }
            comparison.add("first " + millis + " ms limited", sound, Treatment.AS_IS);
        }
        comparison.run("disturbed beginnings, keys of 500 ms");
        assertEquals(0, comparison.of(OURS, "").missed);
        assertEquals(0, comparison.of(OURS, "").extra);
    }

    @Test
    void keysIntoWhichAVoiceStillSpeaksAreHeardOnce() throws Exception {
        short[] speech = Sound.read(Prompts.FRENCH.sample(folder, 12));
        for (int decibels : new int[] {6, 3, 0}) {
            for (int millis : new int[] {60, 300}) {
                Sound sound = new Sound(decibels + millis);
                for (int i = 0; i < KEYS; i++) {
                    int begin = sound.length();
                    sound.silence(600);
                    int from = sound.key(1000, 300);
                    sound.addSpeech(speech, -10 - decibels, begin, from + 8 * millis);
                }
                comparison.add("voice " + decibels + " dB below, until " + millis + " ms", sound, Treatment.AS_IS);
            }
        }
        comparison.run("a voice stops within a key of 1 s");
        assertEquals(0, comparison.of(OURS, "").missed);
    }

    @Test
    void noiseBeforeTheCodecLosesNoKeys() throws Exception {
        for (int decibels : new int[] {25, 20, 16, 12}) {
            for (int i = 0; i < 8; i++) {
                Sound sound = keys(100 * decibels + i, 128);
                sound.addNoise(-7 - decibels, 0, sound.length());
                comparison.add("noise " + decibels + " dB, GSM", sound, Treatment.GSM);
            }
        }
        comparison.run("white noise before GSM 06.10, keys of 100 ms");
        assertTrue(comparison.of(OURS, "noise 16").missed <= 5);
        assertTrue(comparison.of(OURS, "noise 12").missed <= 3);
        assertEquals(0, comparison.of(OURS, "").extra);
    }

    private static Sound keys(long seed, int count) {
        Sound sound = new Sound(seed);
        sound.silence(300);
        for (int i = 0; i < count; i++) {
            sound.key(100, 100);
        }
        return sound;
    }

    @Test
    void everyTreatmentKeepsKeysOfUsualLength() throws Exception {
        for (Treatment treatment : Treatment.values()) {
            // speeds other than 1 change the frequencies by more than Q.24 accepts
            if (!treatment.name().startsWith("SPEED") && treatment != Treatment.LOUDER_CLIPPED) {
                comparison.add(treatment.name(), keys(treatment.ordinal(), 256), treatment);
            }
        }
        comparison.run("codecs, keys of 100 ms");
        assertEquals(0, comparison.of(OURS, "").missed);
        assertEquals(0, comparison.of(OURS, "").extra);
    }

    @Test
    void echoes() throws Exception {
        for (int[] echo : new int[][] {{20, 10}, {50, 6}, {100, 15}, {250, 20}, {250, 30}}) {
            Sound sound = keys(echo[0] + echo[1], KEYS);
            sound.echo(echo[0], echo[1]);
            comparison.add("echo after " + echo[0] + " ms, " + echo[1] + " dB weaker", sound, Treatment.AS_IS);
        }
        comparison.run("echo, keys of 100 ms");
        assertEquals(0, comparison.of(OURS, "").missed);
        assertEquals(0, comparison.of(OURS, "").extra);
    }

    @Test
    void tonesOfTheExchangeUnderTheKeys() throws Exception {
        for (int decibels : new int[] {-6, 0, 6}) {
            for (double[] tones : new double[][] {{480, 620}, {350, 440}, {425, 425}}) {
                Sound sound = keys(decibels, KEYS);
                sound.addSine(tones[0], -10 + decibels, 0, sound.length());
                if (tones[1] != tones[0]) {
                    sound.addSine(tones[1], -10 + decibels, 0, sound.length());
                }
                String kind = String.format("%.0f+%.0f Hz, %+d dB", tones[0], tones[1], decibels);
                comparison.add(kind, sound, Treatment.AS_IS);
            }
        }
        comparison.run("tones of the exchange under the keys");
        assertEquals(0, comparison.of(OURS, "350").missed + comparison.of(OURS, "425").missed);
    }
}
