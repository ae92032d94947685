package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A break with a drop of level, an early echo and a limited beginning make no second key. Each recording has 32 keys; the
 * columns "Asterisk" are the keys that Asterisk's dsp.c (hits to begin 2, misses to end 3) doubles in the same recording.
 */
class BrokenKeysTest {
    private static final long SEED = 19;

    private static void hears(Tape tape) {
        assertEquals(tape.expected.toString(), Bench.text(Bench.hear(tape.samples())));
    }

    /** ES 201 235-3 bridges interruptions below 20 ms, whatever the level that follows. */
    @ParameterizedTest(name = "gap {0} ms, {1} ms of tone {2} dB weaker (Asterisk: {3})")
    @CsvSource(textBlock = """
                     2, 100,  0, 0
                     2, 100, 10, 0
                     2, 100, 12, 0
                     2, 100, 20, 0
                     5, 100,  6, 0
                     5, 100, 10, 0
                     5, 100, 14, 0
                    10, 100, 10, 0
                    10, 100, 14, 0
                    10, 100, 20, 0
                    15, 100, 10, 0
                    15, 100, 14, 0
                    19, 100,  0, 5
                    19, 100, 10, 5
                    19, 100, 14, 5
                    19, 100, 20, 5
                    10, 500, 12, 0
                    10, 500, 20, 0
                    """)
    void aKeyThatBreaksOffAndGoesOnWeakerIsOneKey(int gapMillis, int millis, int drop, int asterisk) {
        hears(BrokenTapes.broken(SEED, 70, gapMillis, millis, drop));
    }

    @ParameterizedTest(name = "echo after {0} ms of a key of 100 ms, {1} dB weaker (Asterisk: {2})")
    @CsvSource(textBlock = """
                     90, 12,  0
                     90, 20,  0
                    100, 12,  0
                    100, 20,  0
                    105, 12,  0
                    105, 20,  0
                    110, 12,  0
                    115, 12,  0
                    120, 12,  6
                    120, 20,  6
                    125, 16, 18
                    125, 20, 18
                    """)
    void anEchoUpTo25MillisecondsAfterItsKeyIsNoSecondKey(int delayMillis, int drop, int asterisk) {
        hears(BrokenTapes.echo(SEED, 150, delayMillis, drop));
    }

    @ParameterizedTest(name = "echo {0} ms later, beginning within the next key, {1} dB weaker")
    @CsvSource({"220, 18", "250, 16", "250, 20", "250, 30", "350, 20"})
    void anEchoThatOutlivesTheNextKeyIsNoKey(int delayMillis, int drop) {
        for (long seed = SEED; seed < SEED + 8; seed++) {
            hears(BrokenTapes.echo(seed, 100, delayMillis, drop));
        }
    }

    @ParameterizedTest(name = "first {0} ms limited, then {1} dB less (Asterisk: {2})")
    @CsvSource({"30, 6, 0", "30, 12, 0", "30, 20, 0", "60, 12, 0", "100, 12, 0", "100, 20, 0"})
    void aKeyThatBeginsTooLoudIsOneKey(int millis, int drop, int asterisk) {
        hears(BrokenTapes.limited(SEED, millis, drop));
    }

    @ParameterizedTest(name = "pause of {0} ms, then {1} dB less (Asterisk misses {2})")
    @CsvSource({"25, 0, 15", "25, 12, 15", "30, 0, 0", "30, 12, 0", "40, 0, 0", "40, 12, 0"})
    void theSameKeyAgainAfterAPauseIsASecondKey(int pauseMillis, int drop, int asteriskMisses) {
        hears(BrokenTapes.twice(SEED, pauseMillis, drop));
    }
}
