package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Guard times, at every place of the tone against the receiver's hops of 20 samples. */
class DigitTrackerTest {
    private static final int HOP = 20;

    private static Tape tape(int offset, double toneMillis, double pauseMillis) {
        Tape tape = new Tape(offset + 31);
        tape.silence(100 + offset / 8.0);
        tape.toneMillis = toneMillis;
        tape.pauseMillis = pauseMillis;
        return tape;
    }

    private static void hears(String expected, Tape tape, String situation) {
        tape.silence(100);
        assertEquals(expected, Bench.text(Bench.hear(tape.samples())), situation);
    }

    @ParameterizedTest
    @CsvSource({"35, 30", "40, 40", "40, 30", "60, 25"})
    void shortTonesAndPausesAreKeysEach(double toneMillis, double pauseMillis) {
        for (int offset = 0; offset < HOP; offset++) {
            hears("5580D", tape(offset, toneMillis, pauseMillis).digits("5580D"), "offset " + offset);
        }
    }

    @ParameterizedTest
    @CsvSource({"10", "15", "20", "22", "23"})
    void tonesTooShortAreNone(double toneMillis) {
        for (int offset = 0; offset < HOP; offset++) {
            hears("", tape(offset, toneMillis, 50).decoys("1590*D"), "offset " + offset);
        }
    }

    @ParameterizedTest
    @CsvSource({"5", "10", "15"})
    void anInterruptionSplitsNoKey(double holeMillis) {
        for (int offset = 0; offset < HOP; offset++) {
            Tape tape = tape(offset, 80 + holeMillis, 60);
            tape.dropOutMillis = holeMillis;
            hears("1590", tape.digits("1590"), "offset " + offset);
        }
    }

    @ParameterizedTest
    @CsvSource({"1, 10", "8, 10", "15, 10", "20, 12", "5, 6"})
    void anEchoIsNoSecondKey(double delayMillis, double decibelsDown) {
        for (int offset = 0; offset < HOP; offset++) {
            hears("1220", tape(offset, 60, 60).digits("1220").echo(delayMillis, decibelsDown), "offset " + offset);
        }
    }

    @ParameterizedTest
    @CsvSource({"100", "1000", "5000"})
    void aKeyHeldDownIsOneKey(double toneMillis) {
        hears("9", tape(3, toneMillis, 60).digits("9"), toneMillis + " ms");
    }

    @ParameterizedTest
    @CsvSource({"15", "3987A"})
    void keysWithoutAPauseAreKeysEach(String keys) {
        for (int offset = 0; offset < HOP; offset++) {
            hears(keys, tape(offset, 60, 0).digits(keys), "offset " + offset);
        }
    }
}
