package simgsm.ss;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.sms.BroadcastCoding;

class UssdTextTest {
    @Test
    void aCodeIsPackedInSeptets() {
        UssdText text = UssdText.of("*100#");

        assertEquals("aa180c3602", text.octets().toString());
        assertEquals(BroadcastCoding.GSM_7BIT, text.coding());
    }

    @ParameterizedTest
    @ValueSource(strings = {"1234567", "12345678", "123456789012345", "ab\rcdef", "[€]", "Ж", "é 日本", "@"})
    void everyTextIsReadBack(String text) throws ProtocolViolation {
        assertEquals(text, UssdText.decode(UssdText.of(text).encode()).text());
    }

    /** TS 23.038, 6.1.2.3.1: seven zero bits would be read as "@". */
    @Test
    void sevenSpareBitsHoldACarriageReturn() {
        assertEquals("31d98c56b3dd1a", UssdText.of("1234567").octets().toString());
    }

    /** The first one stays, the second has no effect on a display. */
    @Test
    void aCarriageReturnAtTheEndIsDoubledSoThatItIsNotTakenForPadding() {
        assertEquals("1234567\r\r", UssdText.of("1234567\r").text());
    }

    @Test
    void theLongestTextHas182CharactersOr80OfAnotherAlphabet() {
        assertEquals(160, UssdText.of("x".repeat(182)).octets().length());
        assertTrue(UssdText.fits("x".repeat(182)));
        assertFalse(UssdText.fits("x".repeat(183)));
        assertTrue(UssdText.fits("Ж".repeat(80)));
        assertFalse(UssdText.fits("Ж".repeat(81)));
        assertFalse(UssdText.fits(""));
        assertThrows(IllegalArgumentException.class, () -> UssdText.of("x".repeat(183)));
        assertThrows(IllegalArgumentException.class, () -> UssdText.of(""));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "30", "3006040108" + "0401", "300404010f0400", "3007" + "0402" + "0f0f" + "040131"})
    void aBrokenParameterIsAViolation(String hex) {
        assertThrows(ProtocolViolation.class, () -> UssdText.decode(OctetString.ofHex(hex)));
    }
}
