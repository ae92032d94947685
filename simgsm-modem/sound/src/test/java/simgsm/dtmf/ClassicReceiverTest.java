package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ClassicReceiverTest {
    private final List<DtmfDigit> heard = new ArrayList<>();
    private final List<KeyCandidate> candidates = new ArrayList<>();

    private String keys(Tape tape, int blockSamples) {
        ClassicReceiver receiver = new ClassicReceiver(heard::add, candidates::add, blockSamples);
        receiver.accept(tape.samples());
        receiver.finish();
        return Bench.text(heard);
    }

    private static Tape keys() {
        Tape tape = new Tape(1);
        tape.silence(100);
        Catalogue.timing(tape, 100, 100);
        return tape;
    }

    @ParameterizedTest
    @ValueSource(ints = {ClassicReceiver.SHORT_BLOCK, ClassicReceiver.LONG_BLOCK})
    void allKeysAreHeardOnAQuietLine(int blockSamples) {
        assertEquals(Catalogue.ALL_KEYS, keys(keys().digits(Catalogue.ALL_KEYS), blockSamples));
    }

    @ParameterizedTest
    @ValueSource(ints = {ClassicReceiver.SHORT_BLOCK, ClassicReceiver.LONG_BLOCK})
    void aTwistBeyondQ24IsNamedAsTheReason(int blockSamples) {
        Tape tape = keys();
        Catalogue.twist(tape, 7);
        assertEquals("", keys(tape.digits("5"), blockSamples));
        assertTrue(
                candidates.stream().anyMatch(candidate -> candidate.reason().startsWith("twist 7")),
                () -> candidates.toString());
    }

    @ParameterizedTest
    @ValueSource(ints = {ClassicReceiver.SHORT_BLOCK, ClassicReceiver.LONG_BLOCK})
    void noiseAsLoudAsTheTonesHidesThem(int blockSamples) {
        assertEquals("", keys(keys().digits("159").noise(-8), blockSamples));
    }

    @ParameterizedTest
    @ValueSource(ints = {ClassicReceiver.SHORT_BLOCK, ClassicReceiver.LONG_BLOCK})
    void eachKeyIsOneCandidate(int blockSamples) {
        keys(keys().digits("159"), blockSamples);
        assertEquals(
                "159",
                candidates.stream()
                        .filter(candidate -> candidate.isOver() && candidate.isAccepted())
                        .map(candidate -> String.valueOf(candidate.key().symbol()))
                        .collect(Collectors.joining()));
    }

    @Test
    void shortBlocksTakeATooHighRowThatTheOtherReceiverRejects() {
        Tape tape = keys();
        tape.rowError = 0.024;
        tape.digits("159");
        assertEquals("159", keys(tape, ClassicReceiver.SHORT_BLOCK));
        assertEquals("", Bench.text(Bench.hear(tape.samples())));
    }
}
