package simgsm.smpp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.time.Instant;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Msisdn;
import simgsm.sms.SmsAddress;

/** Times and addresses of SMPP 3.4. */
class SmppValuesTest {
    private static final Instant NOON = Instant.parse("2026-11-28T12:00:00Z");

    @ParameterizedTest
    @CsvSource({
        "000000013000000R, 2026-11-28T13:30:00Z",
        "010203000005000R, 2028-01-31T12:00:05Z",
        "261128120000000+, 2026-11-28T12:00:00Z",
        "261128120000004+, 2026-11-28T11:00:00Z",
        "261128120000014-, 2026-11-28T15:30:00Z"
    })
    void aTimeIsRelativeOrAbsoluteWithItsZone(String text, Instant time) {
        assertEquals(time, SmppTime.parse(text, NOON));
    }

    @ParameterizedTest
    @CsvSource({"12:00", "26112812000000+", "261128120000000x", "261328120000000+", "261128120000049+"})
    void anythingElseIsRefusedByName(String text) {
        assertThrows(IllegalArgumentException.class, () -> SmppTime.parse(text, NOON));
    }

    @Test
    void aTimeIsWrittenInUniversalTime() {
        assertEquals("261128120000000+", SmppTime.full(NOON));
        assertEquals("2611281200", SmppTime.minutes(NOON));
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 5550100, 5550100, 0",
        "1, 1, +5550100, 5550100, 0",
        "1, 1, 34911234567, 34911234567, 1",
        "5, 0, Alarm, Alarm, 5",
        "0, 0, Alarm, Alarm, 5"
    })
    void anAddressForMobilesIsANumberOrLetters(int ton, int npi, String value, String forMobiles, int type) {
        SmsAddress address = new SmppAddress(ton, npi, value).forMobiles().orElseThrow();

        assertEquals(forMobiles, address.value());
        assertEquals(type, address.type());
    }

    @ParameterizedTest
    @CsvSource({"''", "a name of more than eleven letters"})
    void anyOtherAddressIsNoneForMobiles(String value) {
        assertEquals(Optional.empty(), new SmppAddress(5, 0, value).forMobiles());
    }

    @ParameterizedTest
    @CsvSource({"6, 14, 0", "7, 1, 72", "1, 18, 73"})
    void anInvalidTypeOrPlanHasItsOwnStatus(int ton, int npi, int status) {
        assertEquals(
                status,
                new SmppAddress(ton, npi, "1").check(SmppStatus.INVALID_SOURCE_TYPE, SmppStatus.INVALID_SOURCE_PLAN));
    }

    @Test
    void theAddressOfAMobileKeepsTypeAndPlan() {
        SmppAddress address = SmppAddress.of(new SmsAddress(1, 1, "34911234567"));

        assertEquals(new SmppAddress(1, 1, "34911234567"), address);
        assertEquals(new Msisdn("34911234567"), address.number().orElseThrow());
    }
}
