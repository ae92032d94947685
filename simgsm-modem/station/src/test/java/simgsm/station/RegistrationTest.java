package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.abis.CcmMessage;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement.AuthenticationFailure;
import simgsm.air.MobilityManagement.AuthenticationReject;
import simgsm.air.MobilityManagement.AuthenticationRequest;
import simgsm.air.MobilityManagement.AuthenticationResponse;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.IdentityRequest;
import simgsm.air.MobilityManagement.IdentityResponse;
import simgsm.air.MobilityManagement.ImsiDetachIndication;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingReject;
import simgsm.air.MobilityManagement.LocationUpdatingRequest;
import simgsm.air.MobilityManagement.MmInformation;
import simgsm.air.MobilityManagement.MmStatus;
import simgsm.air.MobilityManagement.TmsiReallocationComplete;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RejectCause;
import simgsm.air.Tmsi;
import simgsm.octets.OctetString;
import simgsm.station.mobility.Sim;

class RegistrationTest {
    private static final OctetString RAND = OctetString.ofHex("23553cbe9637a89d218ae64dae47bf35");

    @Test
    void theCentreAsksForTheIdentityAndThenTheStationRegistersByItsImsi() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.expectNothing();
        scene.identify();
        assertEquals(new CcmMessage.IdentityResponse("SimGSM phone", "490154203237518"), scene.ccm.poll());
        assertEquals(new CcmMessage.IdentityAcknowledge(), scene.ccm.poll());
        LocationUpdatingRequest request = scene.expectFirst(LocationUpdatingRequest.class);
        assertEquals(scene.identity.imsi(), request.identity());
        assertEquals(0, scene.lastSendSequence);
    }

    @Test
    void anAcceptedStationIsRegisteredAndTakesItsTmsi() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        assertEquals(1, scene.lastSendSequence);
        assertEquals(List.of("registered 5550100"), scene.reported.lines());
        assertTrue(scene.station.snapshot().registered());
        scene.releaseChannel();
        scene.expectNothing();
        scene.page(Scene.TMSI);
        assertEquals(Scene.TMSI, scene.expectFirst(PagingResponse.class).identity());
    }

    @Test
    void aCentreThatDoesNotAskIsRegisteredWithAfterTwoSeconds() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.pass(2 * Scene.SECOND - 1);
        scene.expectNothing();
        scene.pass(1);
        scene.expectFirst(LocationUpdatingRequest.class);
    }

    @Test
    void withoutACentreTheStationSaysSoOnce() {
        Scene scene = new Scene();
        scene.linkDown();
        scene.linkDown();
        assertEquals(List.of("unregistered"), scene.reported.lines());
    }

    @Test
    void theImeiIsSentWhenTheNetworkAsks() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.expect(LocationUpdatingRequest.class);
        scene.down(new IdentityRequest(MobileIdentity.Type.IMEI));
        scene.expect(new IdentityResponse(scene.identity.imei()));
        scene.down(new IdentityRequest(MobileIdentity.Type.IMSI));
        scene.expect(new IdentityResponse(scene.identity.imsi()));
    }

    @Test
    void aRejectedStationSaysWhyOnceAndTriesAgainAfterGrowingPauses() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        long pause = Scene.SECOND;
        for (int attempt = 0; attempt < 7; attempt++) {
            scene.expectFirst(LocationUpdatingRequest.class);
            scene.down(new LocationUpdatingReject(RejectCause.ILLEGAL_MS));
            scene.releaseChannel();
            scene.pass(pause - 1);
            scene.expectNothing();
            scene.pass(1);
            pause = Math.min(2 * pause, 16 * Scene.SECOND);
        }
        assertEquals(List.of("unregistered 3"), scene.reported.lines());
        scene.acceptLocationUpdating();
        assertEquals(List.of("unregistered 3", "registered 5550100"), scene.reported.lines());
    }

    @Test
    void anUnansweredRequestIsGivenUpAfterT3210AndRepeated() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.expectFirst(LocationUpdatingRequest.class);
        scene.pass(20 * Scene.SECOND);
        scene.expectReleaseIndication();
        assertEquals(List.of("unregistered"), scene.reported.lines());
        scene.pass(Scene.SECOND);
        scene.expectFirst(LocationUpdatingRequest.class);
    }

    @Test
    void aChannelReleasedWithoutAnAnswerIsAFailureToo() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.expectFirst(LocationUpdatingRequest.class);
        scene.releaseChannel();
        scene.pass(Scene.SECOND);
        scene.expectFirst(LocationUpdatingRequest.class);
    }

    @Test
    void aLostLinkEndsServiceAndANewOneBringsItBack() {
        Scene scene = Scene.registered();
        scene.linkDown();
        assertEquals(List.of("unregistered"), scene.reported.lines());
        scene.pass(Scene.SECOND);
        scene.linkUp();
        scene.identify();
        assertEquals(
                scene.identity.imsi(),
                scene.expectFirst(LocationUpdatingRequest.class).identity());
        scene.down(new LocationUpdatingAccept(LocationArea.TEST, Optional.empty()));
        assertEquals(List.of("unregistered", "registered 5550100"), scene.reported.lines());
    }

    @Test
    void theOperatorsNameStandsInTheSnapshot() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        scene.down(new MmInformation("SimGSM"));
        assertEquals("SimGSM", scene.station.snapshot().networkName());
    }

    @Test
    void aCardWithoutKeyAnswersAChallengeWithFailureAndIsRejectedCleanly() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.expect(LocationUpdatingRequest.class);
        scene.down(new AuthenticationRequest(0, RAND, Optional.empty()));
        scene.expect(new AuthenticationFailure(RejectCause.MAC_FAILURE, Optional.empty()));
        scene.down(new AuthenticationReject());
        scene.releaseChannel();
        assertEquals(List.of("unregistered 3"), scene.reported.lines());
        assertFalse(scene.station.snapshot().registered());
    }

    @ParameterizedTest
    @EnumSource(names = {"IMSI_UNKNOWN_IN_HLR", "ILLEGAL_ME", "PLMN_NOT_ALLOWED"})
    void whatAnotherTryWouldOnlyMeetAgainIsNotTriedAgain(RejectCause cause) {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.expectFirst(LocationUpdatingRequest.class);
        scene.down(new LocationUpdatingReject(cause));
        scene.releaseChannel();
        scene.pass(3_600 * Scene.SECOND);
        scene.expectNothing();
        assertEquals(List.of("unregistered " + cause.code()), scene.reported.lines());
        assertEquals(Optional.of(cause), scene.station.snapshot().rejectCause());
        assertFalse(scene.station.snapshot().cardRefused());
    }

    @Test
    void aRejectedCardIsTriedAgainOnlyAfterSwitchingOnOrInAnotherCell() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        rejectCard(scene);
        assertTrue(scene.station.snapshot().cardRefused());
        scene.pass(3_600 * Scene.SECOND);
        scene.expectNothing();
        scene.station.powerOff();
        assertFalse(scene.station.snapshot().cardRefused());
        scene.station.powerOn();
        rejectCard(scene);
        scene.linkDown();
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        assertTrue(scene.station.snapshot().registered());
        assertFalse(scene.station.snapshot().cardRefused());
    }

    private static void rejectCard(Scene scene) {
        scene.expectFirst(LocationUpdatingRequest.class);
        scene.down(new AuthenticationRequest(0, RAND, Optional.empty()));
        scene.up.poll();
        scene.down(new AuthenticationReject());
        scene.releaseChannel();
    }

    @Test
    void aCallWithARejectedCardEndsAtOnce() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        rejectCard(scene);
        scene.reported.clear();
        scene.station.dial(Scene.OTHER);
        assertEquals(List.of("calling 5550200", "released 38"), scene.reported.lines());
        scene.expectNothing();
    }

    @Test
    void aCardWithAKeyAnswersAndItsKeySequenceIsUsed() {
        OctetString response = OctetString.ofHex("46f8416a");
        Scene scene = new Scene(
                (rand, autn) -> Sim.AuthenticationResult.response(response, OctetString.ofHex("0011223344556677")));
        scene.linkUp();
        scene.identify();
        scene.expect(LocationUpdatingRequest.class);
        scene.down(new AuthenticationRequest(2, RAND, Optional.empty()));
        scene.expect(new AuthenticationResponse(response));
        scene.grantLocationUpdating();
        scene.releaseChannel();
        scene.page(Scene.TMSI);
        assertEquals(2, scene.expectFirst(PagingResponse.class).keySequence());
    }

    @Test
    void pagingForAnotherMobileIsIgnored() {
        Scene scene = Scene.registered();
        scene.page(new Tmsi(0x7777));
        scene.expectNothing();
        scene.page(scene.identity.imsi());
        scene.expectFirst(PagingResponse.class);
        scene.page(scene.identity.imsi());
        scene.expectNothing();
    }

    @Test
    void aPagedChannelWithoutUseIsLeftAfterT3240() {
        Scene scene = Scene.registered();
        scene.page(Scene.TMSI);
        scene.expectFirst(PagingResponse.class);
        scene.pass(10 * Scene.SECOND - 1);
        scene.expectNothing();
        scene.pass(1);
        scene.expectReleaseIndication();
    }

    @Test
    void poweringOffDetachesAndPoweringOnRegistersAgain() {
        Scene scene = Scene.registered();
        scene.station.powerOff();
        assertEquals(Scene.TMSI, scene.expectFirst(ImsiDetachIndication.class).identity());
        assertEquals(List.of("unregistered"), scene.reported.lines());
        assertFalse(scene.station.snapshot().powered());
        scene.releaseChannel();
        assertTrue(scene.station.isDetached());
        assertFalse(scene.station.dial(Scene.OTHER));
        scene.page(scene.identity.imsi());
        scene.expectNothing();
        scene.station.powerOn();
        assertEquals(
                scene.identity.imsi(),
                scene.expectFirst(LocationUpdatingRequest.class).identity());
    }

    @Test
    void aDetachWithoutAnAnswerEndsAfterFiveSeconds() {
        Scene scene = Scene.registered();
        scene.station.powerOff();
        scene.expect(ImsiDetachIndication.class);
        assertFalse(scene.station.isDetached());
        scene.pass(5 * Scene.SECOND);
        scene.expectReleaseIndication();
        assertTrue(scene.station.isDetached());
    }

    @Test
    void aNetworkThatHasForgottenTheStationIsRegisteredWithAnewAndTheServiceAskedAgain() {
        Scene scene = Scene.registered();
        scene.station.dial(Scene.OTHER);
        scene.expectFirst(CmServiceRequest.class);
        scene.down(new CmServiceReject(RejectCause.IMSI_UNKNOWN_IN_VLR));
        scene.expectReleaseIndication();
        scene.acceptLocationUpdating();
        scene.expect(CmServiceRequest.class);
    }

    @Test
    void aSilentCentreIsDroppedAfterThreeUnansweredPings() {
        Scene scene = Scene.registered();
        scene.pass(119 * Scene.SECOND);
        assertEquals(3, scene.ccm.size());
        assertFalse(scene.dropped);
        scene.pass(Scene.SECOND);
        assertTrue(scene.dropped);
    }

    @Test
    void aCentreThatAnswersPingsIsKept() {
        Scene scene = Scene.registered();
        for (int i = 0; i < 10; i++) {
            scene.pass(30 * Scene.SECOND);
            scene.ccm(new CcmMessage.Pong());
        }
        assertEquals(10, scene.ccm.size());
        assertFalse(scene.dropped);
    }

    @Test
    void aPingIsAnsweredAtOnce() {
        Scene scene = Scene.registered();
        scene.ccm(new CcmMessage.Ping());
        assertEquals(new CcmMessage.Pong(), scene.ccm.poll());
    }

    @Test
    void brokenMobilityMessagesGetMmStatusAndChangeNothing() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.expect(LocationUpdatingRequest.class);
        scene.downHex("057f");
        scene.expect(new MmStatus(RejectCause.MESSAGE_TYPE_NON_EXISTENT));
        scene.downHex("0502");
        scene.expect(new MmStatus(RejectCause.INVALID_MANDATORY_INFORMATION));
        scene.downHex("05");
        scene.expectNothing();
        scene.grantLocationUpdating();
        assertEquals(List.of("registered 5550100"), scene.reported.lines());
    }

    @Test
    void nothingIsAnsweredAfterTheChannelIsReleased() {
        Scene scene = Scene.registered();
        scene.down(new ChannelRelease(0));
        scene.down(new IdentityRequest(MobileIdentity.Type.IMEI));
        scene.expectNothing();
    }

    @Test
    void framesOfRubbishDoNotDisturb() {
        Scene scene = Scene.registered();
        scene.frame(0x00, new byte[] {1, 2, 3});
        scene.frame(0xfe, new byte[] {99});
        scene.frame(0xe1, new byte[] {0});
        scene.frame(0x42, new byte[] {0});
        scene.frame(0x00, new byte[0]);
        scene.expectNothing();
        assertTrue(scene.station.snapshot().registered());
    }

    @Test
    void aSecondAcceptanceBringsTheIdentityThatTheNetworkPagesBy() {
        Scene registered = Scene.registered();
        registered.page(Scene.TMSI);
        registered.expectFirst(PagingResponse.class);
        Tmsi next = new Tmsi(0x55aa55aa);
        registered.down(new LocationUpdatingAccept(LocationArea.TEST, Optional.of(next)));
        registered.expect(TmsiReallocationComplete.class);
        registered.releaseChannel();
        registered.page(next);
        assertEquals(next, registered.expectFirst(PagingResponse.class).identity());
        assertEquals(List.of(), registered.reported.lines());
    }

    @Test
    void whoIsPagedByThePermanentIdentityAnswersByIt() {
        Scene registered = Scene.registered();
        registered.page(registered.identity.imsi());
        assertEquals(
                registered.identity.imsi(),
                registered.expectFirst(PagingResponse.class).identity());
    }
}
