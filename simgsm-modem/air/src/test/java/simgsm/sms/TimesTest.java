package simgsm.sms;

import static org.junit.jupiter.api.Assertions.assertEquals;

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
