package simgsm.ss;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.octets.OctetString;

/** notifySS, octet by octet. */
class NotifySsTest {
    /** Wireshark names the service and the status of these octets, and shows ss-Notification (TS 24.080) as an octet. */
    @ParameterizedTest
    @CsvSource({
        "CALL_ON_HOLD, , a10e02010102011030068101428f0101",
        "CALL_RETRIEVED, , a10e02010102011030068101428f0100",
        "OUTGOING_CALL_FORWARDED, FORWARDING_UNCONDITIONAL, a10e0201010201103006810121850104",
        "INCOMING_CALL_FORWARDED, FORWARDING_ON_BUSY, a10e0201010201103006810129850102",
        "FORWARDING_ACTIVE, FORWARDING_UNCONDITIONAL, a10e0201010201103006810121840107"
    })
    void whatHasHappenedIsAnElementAfterTheService(NotifySs what, SsCode condition, String octets) {
        OctetString facility = condition == null ? what.facility() : what.facility(condition);
        assertEquals(OctetString.ofHex(octets), facility);
        assertEquals(Optional.of(what), NotifySs.of(facility));
    }

    /** Both bits, as to a subscriber who forwards a call that was forwarded to it; and an element unknown here. */
    @Test
    void otherBitsAndElementsAreIgnored() {
        assertEquals(
                Optional.of(NotifySs.OUTGOING_CALL_FORWARDED),
                NotifySs.of(OctetString.ofHex("a112020101020110300a8101218902aabb850106")));
    }

    /** Another operation, no argument, call waiting (TS 24.083, 1), an indicator of 2 octets, a broken component, none. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "a10602010102013b",
                "a106020101020110",
                "a10d020101020110300581014 18e00",
                "a10f0201010201103007810142 8f020001",
                "a10e0201",
                ""
            })
    void everythingElseTellsNothing(String facility) {
        assertEquals(Optional.empty(), NotifySs.of(OctetString.ofHex(facility.replace(" ", ""))));
    }
}
