package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Keys that are held although their beginning is disturbed, and keys in noise before a codec, are heard once each. */
class DisturbedKeysTest {
    @Test
    void everyKeyIsHeardOnce() {
        List<String> wrong = new ArrayList<>();
        DisturbedTapes.all(41, 2, (name, tape) -> compare(name, tape, wrong));
        assertEquals(List.of(), wrong);
    }

    /** Levels of -21 to -31 dBm0, frequencies 0.3 to 1.8 % off, no noise but that of 16-bit samples after the first 80 ms. */
    @Test
    void weakKeysAreHeardInTheSilenceAfterNoise() {
        List<String> wrong = new ArrayList<>();
        for (int seed : new int[] {12, 42, 68, 89, 159, 285, 353}) {
            compare("seed " + seed, DisturbedTapes.noisyBeginning(seed, 80, 6), wrong);
        }
        assertEquals(List.of(), wrong);
    }

    private static void compare(String name, Tape tape, List<String> wrong) {
        String heard = Bench.text(Bench.hear(tape.samples()));
        if (!heard.contentEquals(tape.expected)) {
            wrong.add(name + ": expected " + tape.expected + ", heard " + heard);
        }
    }

    @Test
    void tonesThatQ24RejectsAreNoKeysAndLateEchoesNoSecondKeys() {
        List<String> wrong = new ArrayList<>();
        DisturbedTapes.others(41, 10, (name, tape) -> {
            if (!name.startsWith("busy tone")) {
                compare(name, tape, wrong);
            }
        });
        assertEquals(List.of(), wrong);
    }
}
