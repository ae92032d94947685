package blackbox.peers;

import static blackbox.peers.ToneReceiver.MULTIMON_NG;
import static blackbox.peers.ToneReceiver.OURS;
import static blackbox.peers.ToneReceiver.SPANDSP;
import static blackbox.peers.ToneReceiver.SPANDSP_WIDE;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Human speech and music, and keys over human speech: four receivers on the same samples. A sample of what docs/MEASURED.md
 * measured; {@code -Dtones.every=1} takes all recordings (an hour of CPU time).
 */
@Tag("peer")
class RealSpeechTest {
    private static final int EVERY = Integer.getInteger("tones.every", 12);
    private static final int OVER_SPEECH_KEYS = 160;

    @TempDir
    Path folder;

    @Test
    void humanSpeechAndMusicHoldNoKeys() throws Exception {
        Comparison comparison = new Comparison(folder);
        for (Prompts prompts : Prompts.values()) {
            comparison.addSilent(prompts.sample(folder, prompts == Prompts.MUSIC ? Math.min(EVERY, 5) : EVERY));
        }
        comparison.run("speech and music");
        assertEquals(0, comparison.of(OURS, "").extra);
    }

    @Test
    void thePromptThatReadAsAKeyHoldsNone() throws Exception {
        String prompt = Prompts.COLOMBIAN.files().stream()
                .map(Path::toString)
                .filter(file -> file.endsWith("/conf-placeintoconf.gsm"))
                .findFirst()
                .orElseThrow();
        Comparison comparison = new Comparison(folder);
        comparison.addSilent(Prompts.raw(List.of(prompt), folder.resolve("prompt.raw")));
        comparison.run("conf-placeintoconf.gsm");
        assertEquals(0, comparison.of(OURS, "").extra);
    }

    /** French and Colombian speech was not in the fit. */
    @Test
    void keysOverSpeechAreHeard() throws Exception {
        Comparison comparison = new Comparison(folder);
        for (Prompts prompts : List.of(Prompts.FRENCH, Prompts.COLOMBIAN)) {
            short[] speech = Sound.read(prompts.sample(folder, EVERY));
            for (int decibels : new int[] {15, 10, 6, 3}) {
                Sound sound = new Sound(decibels);
                sound.silence(300);
                while (sound.keys.length() < OVER_SPEECH_KEYS) {
                    sound.key(100, 100);
                }
                sound.addSpeech(speech, -10 - decibels, 0, sound.length());
                comparison.add("speech " + decibels + " dB below the tones", sound, Treatment.AS_IS);
            }
        }
        comparison.run("keys over speech");
        assertEquals(0, comparison.of(OURS, "speech 15").missed + comparison.of(OURS, "speech 10").missed);
        for (ToneReceiver other : List.of(SPANDSP, SPANDSP_WIDE)) {
            assertTrue(comparison.of(OURS, "").missed < comparison.of(other, "").missed, other.name());
        }
        assertTrue(comparison.of(OURS, "").extra < comparison.of(MULTIMON_NG, "").extra);
    }
}
