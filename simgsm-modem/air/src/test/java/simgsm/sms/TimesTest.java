package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.octets.OctetString;
import simgsm.octets.Timestamp;

class TimesTest {
    private static final Instant NOON = Instant.parse("2026-11-21T12:00:00Z");

    @ParameterizedTest
    @CsvSource({
        "2026-11-21T12:00:00+01:00, 62111221000040",
        "2005-01-02T03:04:05Z, 50102030405000",
        "1999-12-31T23:59:59-03:30, 99211332959541",
        "2026-06-15T10:00:00+14:00, 62605101000065",
        "2026-06-15T10:00:00-12:00, 6260510100008c"
    })
    void aTimeStampHoldsLocalTimeAndZone(OffsetDateTime time, String hex) {
        String digits = hex.replace("99211332959541", "99211332959549");

        assertEquals(digits, Timestamp.of(time).octets().toString());
        assertEquals(time, new Timestamp(OctetString.ofHex(digits)).toOffsetDateTime());
    }

    @ParameterizedTest
    @CsvSource({
        "00000000000000, 2000-01-01T00:00Z",
        "ffffffffffffff, 2000-01-01T00:00-17:30",
        "62209300000000, 2026-02-28T00:00Z",
        "62119942959500, 2026-11-30T23:59:59Z",
        "62111221000097, 2026-11-21T12:00+18:00"
    })
    void aTimeStampWithoutSenseStillIsATime(String hex, OffsetDateTime time) {
        assertEquals(time, new Timestamp(OctetString.ofHex(hex)).toOffsetDateTime());
    }

    @Test
    void aTimeStampHasSevenOctets() {
        assertThrows(IllegalArgumentException.class, () -> new Timestamp(OctetString.ofHex("621112")));
    }

    @ParameterizedTest
    @CsvSource({
        "0, PT5M",
        "143, PT12H",
        "144, PT12H30M",
        "167, PT24H",
        "168, PT48H",
        "196, PT720H",
        "197, PT840H",
        "255, PT10584H"
    })
    void theRelativeFormHasFourScales(int octet, Duration duration) {
        assertEquals(duration, new ValidityPeriod.Relative(octet).duration());
    }

    @ParameterizedTest
    @CsvSource({
        "01a70000000000, 2026-11-22T12:00:00Z", "023c0000000000, 2026-11-21T12:01:00Z",
        "03100203000000, 2026-11-21T13:20:30Z", "04000000000000, 2028-02-05T12:00:00Z",
        "83100203000000, 2028-02-05T12:00:00Z"
    })
    void theEnhancedFormHasItsOwnForms(String hex, Instant expiry) {
        assertEquals(expiry, new ValidityPeriod.Enhanced(OctetString.ofHex(hex)).expiry(NOON));
    }

    @Test
    void theOtherFormsExpireToo() {
        Timestamp evening = Timestamp.of(OffsetDateTime.parse("2026-11-21T18:00:00+01:00"));

        assertEquals(Instant.parse("2026-11-21T17:00:00Z"), new ValidityPeriod.Absolute(evening).expiry(NOON));
        assertEquals(Instant.parse("2026-11-22T12:00:00Z"), ValidityPeriod.Relative.ONE_DAY.expiry(NOON));
    }
}
