package simgsm.air;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.octets.OctetString;

class IdentitiesTest {
    @ParameterizedTest
    @CsvSource({"5550100, 001010005550100", "1, 001010000000001", "5550100123, 001015550100123"})
    void anOpenNumberAndItsImsiBelongTogether(String number, String imsi) {
        assertEquals(new Imsi(imsi), Imsi.ofOpenNumber(new Msisdn(number)));
        assertEquals(Optional.of(new Msisdn(number)), new Imsi(imsi).openNumber());
    }

    @ParameterizedTest
    @ValueSource(strings = {"0123", "12345678901"})
    void aNumberThatWouldNotComeBackHasNoOpenImsi(String number) {
        assertThrows(IllegalArgumentException.class, () -> Imsi.ofOpenNumber(new Msisdn(number)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"001010000000000", "262420000000017", "00101000555010"})
    void aForeignImsiHasNoOpenNumber(String imsi) {
        assertEquals(Optional.empty(), new Imsi(imsi).openNumber());
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "12345", "1234567890123456", "12345a", "+12345678"})
    void nonsenseIsNoImsi(String digits) {
        assertThrows(IllegalArgumentException.class, () -> new Imsi(digits));
    }

    @ParameterizedTest
    @ValueSource(strings = {"490154203237518", "490154203237510"})
    void anImeiEndsWithItsCheckDigitAlsoIfZeroStoodInItsPlace(String digits) {
        assertEquals("490154203237518", new Imei(digits).toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"490154203237517", "49015420323751", "4901542032375188", "49015420323751x"})
    void nonsenseIsNoImei(String digits) {
        assertThrows(IllegalArgumentException.class, () -> new Imei(digits));
    }

    @Test
    void randomImeisAreSound() {
        Random random = new Random(1);
        for (int i = 0; i < 100; i++) {
            assertEquals(15, Imei.random(random).digits().length());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "1234567890123456", "12*", "-1", "+"})
    void nonsenseIsNoNumber(String digits) {
        assertThrows(IllegalArgumentException.class, () -> Msisdn.parse(digits));
    }

    @Test
    void aPlusSignIsTheTypeInternational() {
        assertEquals(new Msisdn("34976", true), Msisdn.parse("+34976"));
        assertEquals("+34976", Msisdn.parse("+34976").toString());
        assertEquals(new Msisdn("34976"), Msisdn.parse("+34976").plain());
    }

    @Test
    void nonsenseIsNoLocationArea() {
        assertThrows(IllegalArgumentException.class, () -> new LocationArea("01", "01", 1));
        assertThrows(IllegalArgumentException.class, () -> new LocationArea("001", "1", 1));
        assertThrows(IllegalArgumentException.class, () -> new LocationArea("001", "01", 65536));
        assertThrows(IllegalArgumentException.class, () -> new LocationArea("001", "01", -1));
    }

    @Test
    void aThreeDigitNetworkCodeTravels() throws ProtocolViolation {
        MobilityManagement.LocationUpdatingAccept accept =
                new MobilityManagement.LocationUpdatingAccept(new LocationArea("310", "410", 0xfffe), Optional.empty());
        byte[] octets = Layer3Codec.encode(accept, Direction.DOWNLINK, 0);

        assertEquals("0502130014fffe", OctetString.of(octets).toString());
        assertEquals(accept, Layer3Codec.decode(octets, Direction.DOWNLINK));
    }

    @Test
    void aTransactionHasSevenNumbersAndTwoSides() {
        assertThrows(IllegalArgumentException.class, () -> new TransactionIdentifier(7, false));
        assertEquals(new TransactionIdentifier(6, true), new TransactionIdentifier(6, false).answered());
    }
}
