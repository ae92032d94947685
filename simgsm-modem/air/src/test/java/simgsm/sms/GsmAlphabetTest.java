package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class GsmAlphabetTest {
    @Test
    void everyCodeHasItsOwnCharacter() {
        Set<String> characters = new HashSet<>();
        for (int code = 0; code < 128; code++) {
            if (code != GsmAlphabet.ESCAPE) {
                String character = GsmAlphabet.decode(new byte[] {(byte) code});
                assertEquals(1, character.length());
                assertTrue(characters.add(character), () -> character + " twice");
                assertArrayEquals(new byte[] {(byte) code}, GsmAlphabet.encode(character));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({
        "0x00, @", "0x02, $", "0x10, Δ", "0x1a, Ξ", "0x24, ¤", "0x40, ¡", "0x5f, §", "0x60, ¿", "0x7d, ñ", "0x7f, à"
    })
    void theTableIsTheStandards(String code, String character) {
        assertArrayEquals(new byte[] {Integer.decode(code).byteValue()}, GsmAlphabet.encode(character));
    }

    @ParameterizedTest
    @CsvSource({"0x14, ^", "0x28, {", "0x29, }", "0x2f, \\", "0x3c, [", "0x3d, ~", "0x3e, ]", "0x40, |", "0x65, €"})
    void theExtensionTableIsReachedByAnEscape(String code, String character) {
        byte[] codes = {0x1b, Integer.decode(code).byteValue()};

        assertArrayEquals(codes, GsmAlphabet.encode(character));
        assertEquals(character, GsmAlphabet.decode(codes));
    }

    @ParameterizedTest
    @ValueSource(strings = {"á", "`", "\t", "ç", "移", "🤖", "\u001b", "\uffff"})
    void whatHasNoCodeIsRefused(String text) {
        assertFalse(GsmAlphabet.encodes(text));
        assertThrows(IllegalArgumentException.class, () -> GsmAlphabet.encode(text));
    }

    @Test
    void strayEscapesNeverHideText() {
        assertEquals("a", GsmAlphabet.decode(new byte[] {0x1b, 'a'}));
        assertEquals(" b", GsmAlphabet.decode(new byte[] {0x1b, 0x1b, 'b'}));
        assertEquals("c", GsmAlphabet.decode(new byte[] {'c', 0x1b}));
    }
}
