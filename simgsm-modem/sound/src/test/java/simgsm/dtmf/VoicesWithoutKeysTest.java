package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** A man's long "aa" at 110 Hz has harmonics at both tones of a key; its pitch tells it apart. */
class VoicesWithoutKeysTest {
    private static final long SEED = 7;

    @Test
    void vowelsAtEachPitchOfMenAndWomenAreNoKeys() {
        for (int hertz = 85; hertz <= 260; hertz++) {
            assertEquals("", Bench.text(Bench.hear(VoiceTapes.vowels(hertz, SEED))), hertz + " Hz");
        }
    }
}
