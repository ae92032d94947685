package simgsm.classroom.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class LessonFiguresTest {
    private static String of(String function, String... arguments) {
        return new LessonFigures().apply(function, List.of(arguments));
    }

    @Test
    void aKeysFrequenciesAreThoseOfQ23() {
        assertEquals("770 1336", of("low", "5") + " " + of("high", "5"));
        assertEquals("941 1477", of("low", "#") + " " + of("high", "#"));
    }

    @Test
    void theHalvesOfResGiveSres() {
        assertEquals("ffffffff", of("xor", "0f0f0f0ff0f0f0f0"));
        assertEquals("00000001", of("xor", "1000000110000000"));
    }

    @Test
    void digitsAreSwappedAndFilledUp() {
        assertEquals("550502f0", of("swapped", "5550200"));
        assertEquals("2143", of("swapped", "1234"));
    }

    /** Nine characters in eight octets; 2a and 2a and 23 pack to 2a, d5 ... */
    @Test
    void aSubmitIsWrittenAsTs23040HasIt() {
        String hex = of("submit", "5550200", "**#**35**");
        assertEquals("01 00 07 81 55 05 02 f0 00 00 09 2a d5", hex.substring(0, 38));
        assertEquals(3 * (2 + 6 + 3 + 8) - 1, hex.length());
    }

    @Test
    void theReceiversLimitsLieWhereItsTestsPutThem() {
        double half = Double.parseDouble(of("half-heard", "1"));
        assertTrue(half > -9 && half < 0, half + " dB");
        double twist = Double.parseDouble(of("most-twist"));
        assertTrue(twist > 8 && twist < 13, twist + " dB");
        int shortest = Integer.parseInt(of("shortest"));
        assertTrue(shortest > 20 && shortest < 35, shortest + " ms");
    }

    @Test
    void anUnknownFunctionIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> of("nothing"));
    }
}
