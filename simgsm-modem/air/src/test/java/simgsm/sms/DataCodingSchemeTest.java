package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class DataCodingSchemeTest {
    @ParameterizedTest
    @CsvSource({
        "0x00, GSM_7BIT, -1", "0x04, OCTETS, -1", "0x08, UCS2, -1", "0x0c, GSM_7BIT, -1", "0x10, GSM_7BIT, 0",
        "0x18, UCS2, 0", "0x15, OCTETS, 1", "0x20, OCTETS, -1", "0x40, GSM_7BIT, -1", "0x58, UCS2, 0",
        "0x80, GSM_7BIT, -1", "0xc8, GSM_7BIT, -1", "0xd0, GSM_7BIT, -1", "0xe0, UCS2, -1", "0xf0, GSM_7BIT, 0",
        "0xf5, OCTETS, 1", "0xf3, GSM_7BIT, 3"
    })
    void theGroupsAreTheStandards(String octet, Alphabet alphabet, int messageClass) {
        DataCodingScheme scheme = new DataCodingScheme(Integer.decode(octet));

        assertEquals(alphabet, scheme.alphabet());
        assertEquals(messageClass, scheme.messageClass().orElse(-1));
    }

    @ParameterizedTest
    @EnumSource
    void thePlainSchemeOfAnAlphabetIsReadBack(Alphabet alphabet) {
        assertEquals(alphabet, DataCodingScheme.of(alphabet).alphabet());
    }

    @Test
    void anOctetIsAnOctet() {
        assertThrows(IllegalArgumentException.class, () -> new DataCodingScheme(256));
    }
}
