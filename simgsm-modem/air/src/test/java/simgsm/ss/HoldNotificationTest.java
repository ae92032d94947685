package simgsm.ss;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
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

    /** Another operation, no argument, call waiting (TS 24.083, 1), a broken component, none. */
    @ParameterizedTest
    @ValueSource(strings = {"a10602010102013b", "a106020101020110", "a10d020101020110300581014 18e00", "a10e0201", ""})
    void everythingElseTellsNothing(String facility) {
        assertEquals(Optional.empty(), HoldNotification.decode(OctetString.ofHex(facility.replace(" ", ""))));
    }
}
