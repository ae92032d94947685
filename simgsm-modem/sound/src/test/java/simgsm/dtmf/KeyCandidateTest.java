package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class KeyCandidateTest {
    private static List<KeyCandidate> candidates(Tape tape) {
        List<KeyCandidate> over = new ArrayList<>();
        DtmfReceiver receiver = new DtmfReceiver(digit -> {}, candidate -> {
            if (candidate.isOver()) {
                over.add(candidate);
            }
        });
        receiver.accept(tape.samples());
        receiver.finish();
        return over;
    }

    private static Tape tape(double toneMillis) {
        Tape tape = new Tape(1);
        tape.silence(200);
        Catalogue.timing(tape, toneMillis, 100);
        return tape;
    }

    @Test
    void aKeyIsAcceptedWithLogOddsOverTheLimit() {
        KeyCandidate key = candidates(tape(80).digits("5")).get(0);
        assertEquals(DtmfKey.FIVE, key.key());
        assertTrue(key.isAccepted());
        assertTrue(key.score() > key.limit());
        assertEquals(200, key.fromSample() / 8.0, 3);
        assertEquals(230, key.toSample() / 8.0, 3);
        assertTrue(key.reason().matches("log odds [0-9.]+ over 3.5"), key.reason());
    }

    @Test
    void aToneThatIsTooShortSaysHowLongItWas() {
        List<KeyCandidate> over = candidates(tape(20).digits("5"));
        assertFalse(over.isEmpty());
        assertTrue(over.stream().noneMatch(KeyCandidate::isAccepted));
        assertTrue(over.get(0).reason().startsWith("too short"), over.get(0).reason());
    }

    @Test
    void aToneOffItsFrequencySaysByHowMuch() {
        Tape tape = tape(100);
        tape.columnError = 0.035;
        KeyCandidate candidate = candidates(tape.digits("5")).get(0);
        assertEquals(KeyCandidate.Finding.OFF_FREQUENCY, candidate.finding());
        assertEquals(3.5, candidate.value(), 0.5);
    }

    @Test
    void tooMuchTwistIsNamed() {
        Tape tape = tape(100);
        tape.rowDbm0 = -24;
        tape.columnDbm0 = -11.2;
        KeyCandidate candidate = candidates(tape.digits("5")).get(0);
        assertEquals(KeyCandidate.Finding.TWIST, candidate.finding());
        assertEquals(12.8, candidate.value(), 0.3);
    }

    @Test
    void aVoicesPartialsNameTheMeasureThatSpeaksAgainstThem() {
        Tape tape = tape(100);
        tape.digits("A");
        for (int harmonic = 1; harmonic < 12; harmonic++) {
            tape.hum(697.0 / 3 * harmonic, -12);
        }
        assertTrue(candidates(tape).stream()
                .filter(candidate -> candidate.finding() == KeyCandidate.Finding.EVIDENCE)
                .allMatch(candidate -> candidate.score() <= candidate.limit()
                        && candidate.reason().contains("most against: ")));
    }
}
