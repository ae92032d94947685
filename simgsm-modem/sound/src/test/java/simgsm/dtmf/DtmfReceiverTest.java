package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class DtmfReceiverTest {
    /** Digits as they are decided and as they have ended. */
    private static final class Ear implements DtmfListener {
        final List<DtmfDigit> decided = new ArrayList<>();
        final List<DtmfDigit> ended = new ArrayList<>();

        @Override
        public void keyDecided(DtmfDigit digit) {
            decided.add(digit);
        }

        @Override
        public void keyEnded(DtmfDigit digit) {
            ended.add(digit);
        }
    }

    private static Ear hear(short[] samples, int chunk) {
        Ear ear = new Ear();
        DtmfReceiver receiver = new DtmfReceiver(ear);
        for (int at = 0; at < samples.length; at += chunk) {
            receiver.accept(samples, at, Math.min(samples.length, at + chunk));
        }
        receiver.finish();
        return ear;
    }

    private static short[] mixedTape() {
        Tape tape = new Tape(99);
        tape.silence(111).digits("159D");
        tape.toneMillis = 45;
        tape.pauseMillis = 40;
        tape.columnDbm0 = -14;
        tape.digits("*0#A3");
        tape.silence(500).noise(-30);
        tape.add(Voices.atLevel(Voices.speech(tape.random, tape.length()), -25));
        return tape.samples();
    }

    @Test
    void whatIsHeardDoesNotDependOnHowTheStreamIsCut() {
        short[] samples = mixedTape();
        Ear whole = hear(samples, samples.length);
        assertEquals("159D*0#A3", Bench.text(whole.decided));
        for (int chunk : new int[] {1, 7, 19, 20, 21, 160, 333, 1023, 4096}) {
            Ear ear = hear(samples, chunk);
            assertEquals(whole.decided, ear.decided, "chunks of " + chunk);
            assertEquals(whole.ended, ear.ended, "chunks of " + chunk);
        }
    }

    @Test
    void aResetReceiverHearsLikeANewOne() {
        short[] samples = mixedTape();
        Ear ear = new Ear();
        DtmfReceiver receiver = new DtmfReceiver(ear);
        receiver.accept(samples, 0, 1500);
        receiver.reset();
        ear.decided.clear();
        ear.ended.clear();
        receiver.accept(samples);
        receiver.finish();
        assertEquals(hear(samples, samples.length).decided, ear.decided);
    }

    @Test
    void aDigitTellsLevelTwistFrequencyErrorAndDuration() {
        for (DtmfKey key : DtmfKey.values()) {
            Tape tape = new Tape(key.ordinal());
            tape.silence(tape.uniform(50, 60));
            tape.rowDbm0 = tape.uniform(-25, -5);
            tape.columnDbm0 = tape.rowDbm0 + tape.uniform(-7, 7);
            tape.rowError = tape.uniform(-0.015, 0.015);
            tape.columnError = tape.uniform(-0.015, 0.015);
            tape.toneMillis = tape.uniform(60, 200);
            tape.digits(String.valueOf(key.symbol()));
            DtmfDigit digit = hear(tape.samples(), 160).ended.get(0);
            assertEquals(key, digit.key());
            assertEquals(tape.rowDbm0, digit.rowDbm0(), 0.5, key + " row");
            assertEquals(tape.columnDbm0, digit.columnDbm0(), 0.5, key + " column");
            assertEquals(tape.columnDbm0 - tape.rowDbm0, digit.twistDecibels(), 0.7, key + " twist");
            assertEquals(tape.rowError, digit.rowError(), 0.0015, key + " row's error");
            assertEquals(tape.columnError, digit.columnError(), 0.0015, key + " column's error");
            assertEquals(tape.toneMillis, digit.durationMillis(), 4, key + " duration");
            assertEquals(tape.starts.get(0), digit.startedAtSample(), 24, key + " start");
        }
    }

    @Test
    void theErrorOfAKeyIsTheLargerOfItsTones() {
        DtmfDigit digit = new DtmfDigit(DtmfKey.FIVE, 0, 0, 0, -10, -10, 0, 0.01);
        assertEquals(1, digit.frequencyErrorPercent(), 1e-9);
    }

    @Test
    void aKeyIsDecidedBetween23And33MillisAfterItBegins() {
        for (int start = 800; start < 820; start++) {
            Tape tape = new Tape(start);
            tape.silence(start / 8.0).digits("7");
            DtmfDigit digit = hear(tape.samples(), 20).decided.get(0);
            double millis = (digit.decidedAtSample() - start) / 8.0;
            assertTrue(millis > 23 && millis < 33, millis + " ms");
        }
    }

    @Test
    void anInterruptionOfTenOrFifteenMillisNeitherLosesNorDoublesAKeyWhereverItFalls() {
        for (DtmfKey key : DtmfKey.values()) {
            for (int hole = 80; hole <= 120; hole += 40) {
                for (int at = 0; at < 720 - hole; at += 13) {
                    Tape tape = new Tape(1000L * key.ordinal() + at);
                    tape.silence(50 + at % 20 / 8.0);
                    tape.toneMillis = 90;
                    short[] samples = tape.digits(String.valueOf(key.symbol())).samples();
                    int from = tape.starts.get(0) + at;
                    Arrays.fill(samples, from, from + hole, (short) 0);
                    String heard = Bench.text(hear(samples, samples.length).decided);
                    assertEquals(String.valueOf(key.symbol()), heard, hole + " samples, from " + at);
                }
            }
        }
    }

    @Test
    void aKeyThatStillSoundsAtTheEndOfTheStreamEndsThere() {
        Tape tape = new Tape(1);
        tape.pauseMillis = 0;
        tape.toneMillis = 50;
        tape.digits("4");
        Ear ear = hear(tape.samples(), 100);
        assertEquals("4", Bench.text(ear.ended));
        assertEquals(50, ear.ended.get(0).durationMillis(), 5);
    }
}
