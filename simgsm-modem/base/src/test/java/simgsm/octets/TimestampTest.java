package simgsm.octets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.time.OffsetDateTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TimestampTest {
    @ParameterizedTest
    @CsvSource({
        "2026-11-21T12:00:00+01:00, 62111221000040",
        "2005-01-02T03:04:05Z, 50102030405000",
        "1999-12-31T23:59:59-03:30, 99211332959549",
        "2026-06-15T10:00:00+14:00, 62605101000065",
        "2026-06-15T10:00:00-12:00, 6260510100008c"
    })
    void holdsLocalTimeAndZone(OffsetDateTime time, String hex) {
        assertEquals(hex, Timestamp.of(time).octets().toString());
        assertEquals(time, new Timestamp(OctetString.ofHex(hex)).toOffsetDateTime());
    }

    @ParameterizedTest
    @CsvSource({"2026-11-21T12:00:30+01:00, 62111211000340", "2026-11-21T22:00:30-03:30, 62112210030349"})
    void ofMmInformationHoldsUniversalTimeAndZone(OffsetDateTime time, String hex) {
        Timestamp stamp = Timestamp.ofUniversal(time);

        assertEquals(hex, stamp.octets().toString());
        assertEquals(time, stamp.fromUniversal());
    }

    @ParameterizedTest
    @CsvSource({
        "00000000000000, 2000-01-01T00:00Z",
        "ffffffffffffff, 2000-01-01T00:00-17:30",
        "62209300000000, 2026-02-28T00:00Z",
        "62119942959500, 2026-11-30T23:59:59Z",
        "62111221000097, 2026-11-21T12:00+18:00"
    })
    void withoutSenseIsStillATime(String hex, OffsetDateTime time) {
        assertEquals(time, new Timestamp(OctetString.ofHex(hex)).toOffsetDateTime());
    }

    @Test
    void hasSevenOctets() {
        assertThrows(IllegalArgumentException.class, () -> new Timestamp(OctetString.ofHex("621112")));
    }
}
