package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;
import simgsm.sim.CardPin;
import simgsm.sim.PinLock;
import simgsm.station.mobility.Sim;

/** A station whose SIM waits for its PIN (TS 24.008, 4.2.2.3: limited service). */
class LockedCardTest {
    private final PinLock lock = new PinLock(Optional.of(new CardPin("1234", "12345678", true, 3, 10)), kept -> {});
    private final Scene scene = new Scene(new Sim() {
        @Override
        public PinLock lock() {
            return lock;
        }

        @Override
        public AuthenticationResult authenticate(OctetString rand, Optional<OctetString> autn) {
            return Sim.WITHOUT_KEY.authenticate(rand, autn);
        }
    });

    LockedCardTest() {
        scene.linkUp();
        scene.identify();
    }

    @Test
    void onlyEmergencyNumbersAreDialled() {
        assertTrue(scene.station.snapshot().isEmergencyOnly());
        assertFalse(scene.station.dial(new Msisdn("5550200")));
        assertTrue(scene.station.dial(new Msisdn("112")));
        assertEquals(
                ServiceType.EMERGENCY_CALL, scene.expect(CmServiceRequest.class).service());
    }

    @Test
    void withItsPinTheStationRegisters() {
        scene.station.useCard(card -> card.verify("1234"));
        assertFalse(scene.station.snapshot().isEmergencyOnly());
        scene.acceptLocationUpdating();
        scene.releaseChannel();
        assertTrue(scene.station.dial(new Msisdn("5550200")));
    }
}
