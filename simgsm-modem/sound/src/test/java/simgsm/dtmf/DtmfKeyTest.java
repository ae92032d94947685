package simgsm.dtmf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class DtmfKeyTest {
    @ParameterizedTest
    @EnumSource
    void everyKeyIsFoundAgainByItsSymbolAndByItsPlace(DtmfKey key) {
        assertEquals(key, DtmfKey.of(key.symbol()));
        assertEquals(key, DtmfKey.at(key.row(), key.column()));
        assertTrue(DtmfKey.isKey(key.symbol()));
    }

    @Test
    void theKeysLieAsOnATelephone() {
        StringBuilder pad = new StringBuilder();
        for (int row = 0; row < 4; row++) {
            for (int column = 0; column < 4; column++) {
                pad.append(DtmfKey.at(row, column).symbol());
            }
        }
        assertEquals("123A456B789C*0#D", pad.toString());
    }

    @Test
    void theFrequenciesAreThoseOfQ23() {
        assertEquals(697, DtmfKey.ONE.rowHertz());
        assertEquals(1209, DtmfKey.ONE.columnHertz());
        assertEquals(941, DtmfKey.D.rowHertz());
        assertEquals(1633, DtmfKey.D.columnHertz());
        assertEquals(770, DtmfKey.FIVE.rowHertz());
        assertEquals(1336, DtmfKey.FIVE.columnHertz());
        assertEquals(852, DtmfKey.NINE.rowHertz());
        assertEquals(1477, DtmfKey.NINE.columnHertz());
    }

    @ParameterizedTest
    @ValueSource(chars = {'a', 'd', 'E', ' ', '+', '\0', '\uFF11', '\u2217'})
    void whatIsNoKeyIsRefused(char symbol) {
        assertFalse(DtmfKey.isKey(symbol));
        assertThrows(IllegalArgumentException.class, () -> DtmfKey.of(symbol));
    }

    @Test
    void aSequenceIgnoresBlanksOnly() {
        assertEquals(
                List.of(DtmfKey.STAR, DtmfKey.STAR, DtmfKey.HASH, DtmfKey.TWO, DtmfKey.A),
                DtmfKey.sequence(" ** #\t2\nA"));
        assertThrows(IllegalArgumentException.class, () -> DtmfKey.sequence("12-3"));
    }

    @Test
    void thereIsNoKeyOutsideThePad() {
        assertThrows(IllegalArgumentException.class, () -> DtmfKey.at(4, 0));
        assertThrows(IllegalArgumentException.class, () -> DtmfKey.at(0, -1));
    }
}
