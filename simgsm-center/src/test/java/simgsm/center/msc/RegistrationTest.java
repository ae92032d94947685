package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.abis.CcmMessage;
import simgsm.air.Imsi;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.RadioResource;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;

class RegistrationTest {
    private static final Msisdn NUMBER = new Msisdn("5550100");

    private final TestNetwork network = new TestNetwork();

    @Test
    void aTerminalIsAskedForItsIdentityAsSoonAsItConnects() {
        TestMobile mobile = network.connect("5550100");
        mobile.next(CcmMessage.IdentityRequest.class);
        mobile.ccm(new CcmMessage.IdentityResponse("SimGSM phone", "001017500000017"));
        mobile.next(CcmMessage.IdentityAcknowledge.class);
        assertTrue(mobile.hasNothing());
    }

    @Test
    void aNewSimRegistersUnderTheNumberInItsImsi() {
        TestMobile mobile = network.connect("5550100");
        mobile.next(CcmMessage.IdentityRequest.class);
        mobile.requestUpdate(mobile.imsi);
        assertEquals(
                MobileIdentity.Type.IMEI,
                mobile.next(MobilityManagement.IdentityRequest.class).identityType());
        mobile.tell(new MobilityManagement.IdentityResponse(mobile.imei));
        MobilityManagement.LocationUpdatingAccept accept = mobile.next(MobilityManagement.LocationUpdatingAccept.class);
        assertEquals(LocationArea.TEST, accept.area());
        assertTrue(accept.newIdentity().orElseThrow() instanceof Tmsi);
        mobile.tell(new MobilityManagement.TmsiReallocationComplete());
        assertEquals(
                "SimGSM", mobile.next(MobilityManagement.MmInformation.class).networkName());
        mobile.next(RadioResource.ChannelRelease.class);
        mobile.leaveChannel();
        assertTrue(mobile.hasNothing());
        assertEquals(List.of(new ExchangeEvent.Attached(NUMBER)), network.events);
    }

    @Test
    void aMobileThatComesBackWithItsTmsiIsKnown() {
        TestMobile mobile = network.attach("5550100");
        MobileIdentity first = mobile.identity();
        mobile.requestUpdate(first);
        assertEquals(
                MobileIdentity.Type.IMEI,
                mobile.next(MobilityManagement.IdentityRequest.class).identityType());
        mobile.tell(new MobilityManagement.IdentityResponse(mobile.imei));
        MobileIdentity second = mobile.next(MobilityManagement.LocationUpdatingAccept.class)
                .newIdentity()
                .orElseThrow();
        assertFalse(first.equals(second));
        assertEquals(1, network.events.size(), "still attached, so no second event");
    }

    @Test
    void aTmsiOfAnotherTimeIsAskedForItsImsi() {
        TestMobile mobile = network.connect("5550100");
        mobile.received.clear();
        mobile.requestUpdate(new Tmsi(0x12345678));
        assertEquals(
                MobileIdentity.Type.IMSI,
                mobile.next(MobilityManagement.IdentityRequest.class).identityType());
        mobile.tell(new MobilityManagement.IdentityResponse(mobile.imsi));
        assertEquals(
                MobileIdentity.Type.IMEI,
                mobile.next(MobilityManagement.IdentityRequest.class).identityType());
    }

    @Test
    void aSimOfAnotherNetworkIsRejectedWithCause2() {
        assertEquals(RejectCause.IMSI_UNKNOWN_IN_HLR, rejectionOf(new Imsi("262420000000017")));
        assertEquals(RejectCause.IMSI_UNKNOWN_IN_HLR, rejectionOf(new Imsi("001010000000000")));
        assertTrue(network.events.isEmpty());
    }

    @Test
    void aNumberIsKnownFromItsFirstRegistrationAndNotFromARequest() {
        TestMobile mobile = network.connect("5550100");
        mobile.received.clear();
        mobile.requestUpdate(mobile.imsi);
        mobile.next(MobilityManagement.IdentityRequest.class);
        assertFalse(network.exchange.isKnown(NUMBER));
        network.passSeconds(12);
        mobile.leaveReleasedChannel();
        assertTrue(network.exchange.subscribers().isEmpty());
        mobile.register();
        assertTrue(network.exchange.isKnown(NUMBER));
        mobile.vanish();
        assertTrue(network.exchange.isKnown(NUMBER), "once registered, always known");
    }

    @Test
    void ofTwoEquipmentsThatRegisterANewNumberAtOnceTheFirstToFinishGetsIt() {
        TestMobile first = network.connect("5550100");
        TestMobile second = network.connect("5550100");
        for (TestMobile mobile : List.of(first, second)) {
            mobile.received.clear();
            mobile.requestUpdate(mobile.imsi);
            mobile.next(MobilityManagement.IdentityRequest.class);
        }
        second.tell(new MobilityManagement.IdentityResponse(second.imei));
        first.tell(new MobilityManagement.IdentityResponse(first.imei));
        second.next(MobilityManagement.LocationUpdatingAccept.class);
        assertEquals(
                RejectCause.ILLEGAL_MS,
                first.next(MobilityManagement.LocationUpdatingReject.class).cause());
        assertEquals(1, network.exchange.subscribers().size());
    }

    private RejectCause rejectionOf(MobileIdentity identity) {
        TestMobile mobile = network.connect("5550100");
        mobile.received.clear();
        mobile.requestUpdate(identity);
        RejectCause cause =
                mobile.next(MobilityManagement.LocationUpdatingReject.class).cause();
        mobile.next(RadioResource.ChannelRelease.class);
        return cause;
    }

    @ParameterizedTest
    @CsvSource({"an IMEI of 13 digits, 0559074a095124303257", "an IMEI of letters, 0559084a0951243032ab81"})
    void equipmentWithAnImpossibleIdentityIsRejectedWithCause6(String what, String identityResponse) {
        TestMobile mobile = network.connect("5550100");
        mobile.received.clear();
        mobile.requestUpdate(mobile.imsi);
        mobile.next(MobilityManagement.IdentityRequest.class);
        mobile.tellOctets(identityResponse);
        mobile.next(MobilityManagement.MmStatus.class);
        assertEquals(
                RejectCause.ILLEGAL_ME,
                mobile.next(MobilityManagement.LocationUpdatingReject.class).cause(),
                what);
        mobile.leaveReleasedChannel();
        assertTrue(network.events.isEmpty());
    }

    @Test
    void theSameEquipmentOnANewLinkReplacesItsOldOne() {
        TestMobile old = network.attach("5550100");
        TestMobile fresh = network.connect("5550100", old.imei).register();
        assertTrue(old.closedFor.isPresent());
        assertTrue(fresh.closedFor.isEmpty());
        assertEquals(1, network.exchange.linkCount());
        assertEquals(
                List.of(
                        new ExchangeEvent.Attached(NUMBER),
                        new ExchangeEvent.Detached(NUMBER),
                        new ExchangeEvent.Attached(NUMBER)),
                network.events);
    }

    @Test
    void anotherEquipmentClaimingANumberWhoseLinkLivesIsRejectedWithCause3() {
        TestMobile owner = network.attach("5550100");
        TestMobile claimant = network.connect("5550100");
        claimant.received.clear();
        claimant.requestUpdate(claimant.imsi);
        claimant.next(MobilityManagement.IdentityRequest.class);
        claimant.tell(new MobilityManagement.IdentityResponse(claimant.imei));
        assertEquals(
                RejectCause.ILLEGAL_MS,
                claimant.next(MobilityManagement.LocationUpdatingReject.class).cause());
        claimant.leaveReleasedChannel();
        assertTrue(owner.closedFor.isEmpty());
        assertEquals(1, network.events.size());
    }

    @Test
    void anotherEquipmentMayTakeANumberWhoseLinkIsGone() {
        network.attach("5550100").vanish();
        network.attach("5550100");
        assertEquals(new ExchangeEvent.Attached(NUMBER), network.events.get(2));
    }

    @Test
    void aMobileThatDetachesIsDetachedAndItsChannelReleased() {
        TestMobile mobile = network.attach("5550100");
        mobile.establish(new MobilityManagement.ImsiDetachIndication(mobile.identity()));
        mobile.leaveReleasedChannel();
        assertEquals(new ExchangeEvent.Detached(NUMBER), network.events.get(1));
        mobile.register();
        assertEquals(new ExchangeEvent.Attached(NUMBER), network.events.get(2));
    }

    @Test
    void aLostLinkDetachesOnce() {
        TestMobile mobile = network.attach("5550100");
        mobile.vanish();
        mobile.vanish();
        assertEquals(List.of(new ExchangeEvent.Attached(NUMBER), new ExchangeEvent.Detached(NUMBER)), network.events);
    }

    @Test
    void aMobileWithoutAnIdentityLosesItsChannelAfter12Seconds() {
        TestMobile mobile = network.connect("5550100");
        mobile.received.clear();
        mobile.requestUpdate(mobile.imsi);
        mobile.next(MobilityManagement.IdentityRequest.class);
        network.passSeconds(11);
        assertTrue(mobile.hasNothing());
        network.passSeconds(1);
        mobile.leaveReleasedChannel();
        assertTrue(network.events.isEmpty());
    }

    @Test
    void aSecondRequestOnTheSameConnectionStartsAnew() {
        TestMobile mobile = network.connect("5550100");
        mobile.received.clear();
        mobile.requestUpdate(mobile.imsi);
        mobile.next(MobilityManagement.IdentityRequest.class);
        mobile.requestUpdate(mobile.imsi);
        mobile.next(MobilityManagement.IdentityRequest.class);
        mobile.tell(new MobilityManagement.IdentityResponse(mobile.imei));
        mobile.next(MobilityManagement.LocationUpdatingAccept.class);
    }

    @Test
    void aDuplicateIsDroppedByItsSendSequenceNumber() {
        TestMobile mobile = network.connect("5550100");
        mobile.received.clear();
        mobile.requestUpdate(mobile.imsi);
        mobile.next(MobilityManagement.IdentityRequest.class);
        MobilityManagement.IdentityResponse response = new MobilityManagement.IdentityResponse(mobile.imei);
        mobile.tell(response);
        mobile.next(MobilityManagement.LocationUpdatingAccept.class);
        mobile.repeat(response);
        assertTrue(mobile.hasNothing(), "no MM STATUS, no second ACCEPT");
        mobile.tell(new MobilityManagement.TmsiReallocationComplete());
        mobile.next(MobilityManagement.MmInformation.class);
    }

    @Test
    void anUnrequestedAnswerGetsMmStatus98() {
        TestMobile mobile = network.attach("5550100");
        mobile.requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
        mobile.tell(new MobilityManagement.TmsiReallocationComplete());
        assertEquals(
                RejectCause.MESSAGE_NOT_COMPATIBLE_WITH_STATE,
                mobile.next(MobilityManagement.MmStatus.class).cause());
    }

    @Test
    void serviceIsRefusedToAnUnregisteredMobile() {
        TestMobile stranger = network.connect("5550100");
        stranger.received.clear();
        stranger.establish(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL, MobilityManagement.NO_KEY, stranger.imsi));
        assertEquals(
                RejectCause.IMSI_UNKNOWN_IN_VLR,
                stranger.next(MobilityManagement.CmServiceReject.class).cause());
        stranger.leaveReleasedChannel();
    }

    @Test
    void noMobileIsServedUnderAnotherIdentity() {
        TestMobile victim = network.attach("5550100");
        TestMobile thief = network.attach("5550101");
        thief.establish(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.SHORT_MESSAGE, MobilityManagement.NO_KEY, victim.identity()));
        assertEquals(
                RejectCause.IMSI_UNKNOWN_IN_VLR,
                thief.next(MobilityManagement.CmServiceReject.class).cause());
    }

    @Test
    void aServiceThatIsNotBegunLosesItsChannelAfter10Seconds() {
        TestMobile mobile = network.attach("5550100");
        mobile.requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
        network.passSeconds(9);
        assertTrue(mobile.hasNothing());
        network.passSeconds(1);
        mobile.leaveReleasedChannel();
    }

    @Test
    void whoeverRegistersUnderASecondNumberLeavesTheFirst() {
        TestMobile mobile = network.attach("5550100");
        mobile.requestUpdate(Imsi.ofOpenNumber(new Msisdn("5550101")));
        mobile.next(MobilityManagement.IdentityRequest.class);
        mobile.tell(new MobilityManagement.IdentityResponse(mobile.imei));
        mobile.next(MobilityManagement.LocationUpdatingAccept.class);
        assertEquals(
                List.of(
                        new ExchangeEvent.Attached(NUMBER),
                        new ExchangeEvent.Detached(NUMBER),
                        new ExchangeEvent.Attached(new Msisdn("5550101"))),
                network.events);
        assertEquals(Optional.empty(), mobile.closedFor);
    }
}
