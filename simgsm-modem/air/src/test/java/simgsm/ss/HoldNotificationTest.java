package simgsm.ss;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.octets.OctetString;

/** notifySS with the CallOnHold indicator, octet by octet. */
class HoldNotificationTest {
    @Test
    void theIndicatorStandsBehindTheService() {
        assertEquals(OctetString.ofHex("a10e02010102011030068101428f0101"), HoldNotification.encode(true));
        assertEquals(OctetString.ofHex("a10e02010102011030068101428f0100"), HoldNotification.encode(false));
        assertEquals(Optional.of(true), HoldNotification.decode(HoldNotification.encode(true)));
        assertEquals(Optional.of(false), HoldNotification.decode(HoldNotification.encode(false)));
    }

    /** Wireshark names the service and the status of these octets, and shows ss-Notification (TS 24.080) as an octet. */
    @ParameterizedTest
    @CsvSource({
        "OUTGOING_CALL_FORWARDED, FORWARDING_UNCONDITIONAL, a10e0201010201103006810121850104",
        "INCOMING_CALL_FORWARDED, FORWARDING_ON_BUSY, a10e0201010201103006810129850102",
        "ACTIVE, FORWARDING_UNCONDITIONAL, a10e0201010201103006810121840107"
    })
    void aForwardingIsToldByNotificationOrStatus(HoldNotification.Forwarding what, SsCode condition, String octets) {
        OctetString facility = HoldNotification.encode(what, condition);
        assertEquals(OctetString.ofHex(octets), facility);
        assertEquals(Optional.of(what), HoldNotification.forwarding(facility));
        assertEquals(Optional.empty(), HoldNotification.decode(facility));
    }

    /** Another operation, no argument, call waiting (TS 24.083, 1), a broken component, none. */
    @ParameterizedTest
    @ValueSource(strings = {"a10602010102013b", "a106020101020110", "a10d020101020110300581014 18e00", "a10e0201", ""})
    void everythingElseTellsNothing(String facility) {
        OctetString octets = OctetString.ofHex(facility.replace(" ", ""));
        assertEquals(Optional.empty(), HoldNotification.decode(octets));
        assertEquals(Optional.empty(), HoldNotification.forwarding(octets));
    }
}
