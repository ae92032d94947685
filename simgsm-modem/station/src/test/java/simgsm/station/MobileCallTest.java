package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.CallControl.Alerting;
import simgsm.air.CallControl.CallConfirmed;
import simgsm.air.CallControl.CallProceeding;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.ConnectAcknowledge;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.CallControl.Progress;
import simgsm.air.CallControl.Release;
import simgsm.air.CallControl.ReleaseComplete;
import simgsm.air.CallControl.Setup;
import simgsm.air.CallControl.Status;
import simgsm.air.CallControl.StatusEnquiry;
import simgsm.air.Cause;
import simgsm.air.MobilityManagement.CmServiceAbort;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.ImsiDetachIndication;
import simgsm.air.MobilityManagement.LocationUpdatingReject;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RejectCause;
import simgsm.air.TransactionIdentifier;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simgsm.station.call.MobileCallTable.MobileCallState;

class MobileCallTest {
    /** As our own messages carry it, and as the network answers. */
    private static final TransactionIdentifier OWN = new TransactionIdentifier(0, false);

    private static final TransactionIdentifier TO_OWN = OWN.answered();
    /** Of a call that the network opens, and as we answer. */
    private static final TransactionIdentifier THEIRS = new TransactionIdentifier(3, false);

    private static final TransactionIdentifier TO_THEIRS = THEIRS.answered();
    private static final Msisdn THIRD = new Msisdn("5550999");

    private static Scene dialled() {
        Scene scene = Scene.registered();
        assertTrue(scene.station.dial(Scene.OTHER));
        scene.acceptService();
        scene.expect(new Setup(OWN, Optional.empty(), Optional.of(Scene.OTHER)));
        return scene;
    }

    private static Scene active() {
        Scene scene = dialled();
        scene.down(new CallProceeding(TO_OWN));
        scene.down(new Alerting(TO_OWN));
        scene.down(new Connect(TO_OWN));
        scene.expect(new ConnectAcknowledge(OWN));
        scene.reported.clear();
        return scene;
    }

    private static Scene ringing() {
        Scene scene = Scene.registered();
        scene.page(Scene.TMSI);
        scene.expectFirst(PagingResponse.class);
        scene.down(new Setup(THEIRS, Optional.of(Scene.OTHER), Optional.empty()));
        scene.expect(new CallConfirmed(TO_THEIRS));
        scene.expect(new Alerting(TO_THEIRS));
        assertEquals(List.of("ringing 5550200"), scene.reported.lines());
        return scene;
    }

    private static MobileCallState stateOf(Scene scene) {
        return scene.station.snapshot().callState();
    }

    @Test
    void aStationWithTheFaultLeavesSetupUnanswered() {
        Scene scene = Scene.registered(new StationOptions(SpeechCodec.Kind.A_LAW, CallAudioListener.NONE, true, true));
        scene.page(Scene.TMSI);
        scene.expectFirst(PagingResponse.class);
        scene.down(new Setup(THEIRS, Optional.of(Scene.OTHER), Optional.empty()));
        scene.expectNothing();
        assertEquals(MobileCallState.NULL, stateOf(scene));
    }

    @Test
    void anOwnCallGoesFromDiallingToConversation() {
        Scene scene = Scene.registered();
        scene.station.dial(Scene.OTHER);
        assertEquals(MobileCallState.MM_CONNECTION_PENDING, stateOf(scene));
        CmServiceRequest request = scene.expectFirst(CmServiceRequest.class);
        assertEquals(ServiceType.MOBILE_ORIGINATED_CALL, request.service());
        assertEquals(Scene.TMSI, request.identity());
        assertEquals(0, scene.lastSendSequence);
        scene.down(new CmServiceAccept());
        scene.expect(Setup.class);
        assertEquals(1, scene.lastSendSequence);
        assertEquals(MobileCallState.CALL_INITIATED, stateOf(scene));
        scene.down(new CallProceeding(TO_OWN));
        assertEquals(MobileCallState.MO_CALL_PROCEEDING, stateOf(scene));
        scene.down(new Alerting(TO_OWN));
        assertEquals(MobileCallState.CALL_DELIVERED, stateOf(scene));
        scene.down(new Connect(TO_OWN));
        scene.expect(new ConnectAcknowledge(OWN));
        assertEquals(0, scene.lastSendSequence);
        assertEquals(MobileCallState.ACTIVE, stateOf(scene));
        assertEquals(Optional.of(Scene.OTHER), scene.station.snapshot().peer());
        assertEquals(List.of("calling 5550200", "alerting", "connected 5550200"), scene.reported.lines());
    }

    @Test
    void aCallMayBeConnectedWithoutAlerting() {
        Scene scene = dialled();
        scene.down(new Connect(TO_OWN));
        scene.expect(new ConnectAcknowledge(OWN));
        assertEquals(List.of("calling 5550200", "connected 5550200"), scene.reported.lines());
    }

    @Test
    void anIncomingCallRingsAndIsAnswered() {
        Scene scene = ringing();
        assertEquals(MobileCallState.CALL_RECEIVED, stateOf(scene));
        assertTrue(scene.station.answer());
        scene.expect(new Connect(TO_THEIRS));
        assertEquals(MobileCallState.CONNECT_REQUEST, stateOf(scene));
        assertTrue(scene.spoken.isEmpty());
        scene.down(new ConnectAcknowledge(THEIRS));
        assertEquals(MobileCallState.ACTIVE, stateOf(scene));
        assertEquals(List.of("ringing 5550200", "connected 5550200"), scene.reported.lines());
        assertFalse(scene.station.answer());
    }

    @Test
    void aUserMayAnswerFromWithinTheRinging() {
        Scene scene = Scene.registered();
        scene.reported.answersAtOnce = true;
        scene.page(Scene.TMSI);
        scene.expect(PagingResponse.class);
        scene.down(new Setup(THEIRS, Optional.empty(), Optional.empty()));
        scene.expect(new CallConfirmed(TO_THEIRS));
        scene.expect(new Alerting(TO_THEIRS));
        scene.expect(new Connect(TO_THEIRS));
        assertEquals(List.of("ringing ?"), scene.reported.lines());
    }

    @Test
    void hangingUpSaysCause16AndClearsInThreeSteps() {
        Scene scene = active();
        assertTrue(scene.station.hangUp());
        scene.expect(new Disconnect(OWN, Cause.NORMAL_CALL_CLEARING));
        assertEquals(List.of("released 16"), scene.reported.lines());
        assertEquals(MobileCallState.DISCONNECT_REQUEST, stateOf(scene));
        assertFalse(scene.station.hangUp());
        scene.down(new Release(TO_OWN, Optional.empty()));
        scene.expect(new ReleaseComplete(OWN, Optional.empty()));
        assertEquals(MobileCallState.NULL, stateOf(scene));
        scene.releaseChannel();
        assertEquals(List.of("released 16"), scene.reported.lines());
    }

    @Test
    void theNetworksDisconnectIsReleasedAndItsCauseReported() {
        Scene scene = active();
        scene.down(new Disconnect(TO_OWN, Cause.USER_ALERTING_NO_ANSWER));
        scene.expect(new Release(OWN, Optional.empty()));
        assertEquals(MobileCallState.RELEASE_REQUEST, stateOf(scene));
        scene.down(new ReleaseComplete(TO_OWN, Optional.empty()));
        assertEquals(MobileCallState.NULL, stateOf(scene));
        assertEquals(List.of("released 19"), scene.reported.lines());
    }

    @Test
    void aCallRefusedAtOnceIsReleasedWithItsCause() {
        Scene scene = dialled();
        scene.down(new ReleaseComplete(TO_OWN, Optional.of(Cause.UNASSIGNED_NUMBER)));
        assertEquals(List.of("calling 5550200", "released 1"), scene.reported.lines());
        assertEquals(MobileCallState.NULL, stateOf(scene));
    }

    @Test
    void aBusyCalledPartyIsReported() {
        Scene scene = dialled();
        scene.down(new CallProceeding(TO_OWN));
        scene.down(new Disconnect(TO_OWN, Cause.USER_BUSY));
        scene.expect(new Release(OWN, Optional.empty()));
        assertEquals(List.of("calling 5550200", "released 17"), scene.reported.lines());
    }

    @Test
    void releaseWithoutDisconnectIsAnsweredAndEndsTheCall() {
        Scene scene = active();
        scene.down(new Release(TO_OWN, Optional.of(Cause.NETWORK_OUT_OF_ORDER)));
        scene.expect(new ReleaseComplete(OWN, Optional.empty()));
        assertEquals(List.of("released 38"), scene.reported.lines());
    }

    @Test
    void bothMayDisconnectAtOnce() {
        Scene scene = active();
        scene.station.hangUp();
        scene.expect(Disconnect.class);
        scene.down(new Disconnect(TO_OWN, Cause.NORMAL_CALL_CLEARING));
        scene.expect(new Release(OWN, Optional.empty()));
        scene.down(new Release(TO_OWN, Optional.empty()));
        scene.expectNothing();
        assertEquals(MobileCallState.NULL, stateOf(scene));
        assertEquals(List.of("released 16"), scene.reported.lines());
    }

    @Test
    void hangingUpARingingCallRejectsIt() {
        Scene scene = ringing();
        scene.station.hangUp();
        scene.expect(new Disconnect(TO_THEIRS, Cause.CALL_REJECTED));
        assertEquals(List.of("ringing 5550200", "released 16"), scene.reported.lines());
    }

    @Test
    void aReleaseByTheCallerStopsTheRinging() {
        Scene scene = ringing();
        scene.down(new Disconnect(THEIRS, Cause.NORMAL_CALL_CLEARING));
        scene.expect(new Release(TO_THEIRS, Optional.empty()));
        assertFalse(scene.station.answer());
        assertEquals(List.of("ringing 5550200", "released 16"), scene.reported.lines());
    }

    @Test
    void aSecondCallerIsTurnedAwayBusy() {
        Scene scene = active();
        TransactionIdentifier second = new TransactionIdentifier(5, false);
        scene.down(new Setup(second, Optional.of(THIRD), Optional.empty()));
        scene.expect(new ReleaseComplete(second.answered(), Optional.of(Cause.USER_BUSY)));
        assertEquals(MobileCallState.ACTIVE, stateOf(scene));
        assertEquals(List.of(), scene.reported.lines());
        assertFalse(scene.station.dial(THIRD));
    }

    @Test
    void aCallerIsBusyAlreadyWhileItDials() {
        Scene scene = dialled();
        scene.down(new Setup(THEIRS, Optional.of(THIRD), Optional.empty()));
        scene.expect(new ReleaseComplete(TO_THEIRS, Optional.of(Cause.USER_BUSY)));
    }

    @Test
    void aRepeatedSetupIsIgnored() {
        Scene scene = ringing();
        scene.down(new Setup(THEIRS, Optional.of(Scene.OTHER), Optional.empty()));
        scene.expectNothing();
    }

    @Test
    void withoutServiceACallWaitsFiveSecondsForIt() {
        Scene scene = new Scene();
        scene.linkDown();
        assertTrue(scene.station.dial(Scene.OTHER));
        scene.pass(5 * Scene.SECOND - 1);
        assertEquals(List.of("unregistered", "calling 5550200"), scene.reported.lines());
        scene.pass(1);
        assertEquals(List.of("unregistered", "calling 5550200", "released 38"), scene.reported.lines());
        assertFalse(scene.station.hangUp());
    }

    @Test
    void aCallDialledBeforeTheCentreIsFoundIsSetUpOnceRegistered() {
        Scene scene = new Scene();
        assertTrue(scene.station.dial(Scene.OTHER));
        scene.linkDown();
        scene.pass(3 * Scene.SECOND);
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        scene.acceptService();
        scene.expect(new Setup(OWN, Optional.empty(), Optional.of(Scene.OTHER)));
        scene.pass(5 * Scene.SECOND);
        assertEquals(MobileCallState.CALL_INITIATED, stateOf(scene));
        assertEquals(List.of("calling 5550200", "unregistered", "registered 5550100"), scene.reported.lines());
    }

    @Test
    void aCallThatWaitsForServiceIsReleasedWhenTheNetworkRefusesIt() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.station.dial(Scene.OTHER);
        scene.down(new LocationUpdatingReject(RejectCause.ILLEGAL_MS));
        assertEquals(List.of("calling 5550200", "unregistered 3", "released 38"), scene.reported.lines());
    }

    @Test
    void whereTheNetworkHasRefusedServiceADiallerHearsAtOnce() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.down(new LocationUpdatingReject(RejectCause.ILLEGAL_MS));
        scene.station.dial(Scene.OTHER);
        assertEquals(List.of("unregistered 3", "calling 5550200", "released 38"), scene.reported.lines());
    }

    @Test
    void aCallThatWaitsForServiceCanBeHungUp() {
        Scene scene = new Scene();
        scene.station.dial(Scene.OTHER);
        assertTrue(scene.station.hangUp());
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        scene.expectNothing();
        assertEquals(List.of("calling 5550200", "released 16", "registered 5550100"), scene.reported.lines());
    }

    @Test
    void aCallDialledWhileRegisteringWaitsForIt() {
        Scene scene = new Scene();
        scene.linkUp();
        scene.identify();
        scene.station.dial(Scene.OTHER);
        scene.acceptLocationUpdating();
        scene.acceptService();
        scene.expect(Setup.class);
    }

    @Test
    void aRefusedServiceReleasesTheCall() {
        Scene scene = Scene.registered();
        scene.station.dial(Scene.OTHER);
        scene.expect(CmServiceRequest.class);
        scene.down(new CmServiceReject(RejectCause.CONGESTION));
        assertEquals(List.of("calling 5550200", "released 42"), scene.reported.lines());
    }

    @Test
    void anUnansweredServiceRequestIsGivenUpAfterT3230() {
        Scene scene = Scene.registered();
        scene.station.dial(Scene.OTHER);
        scene.expect(CmServiceRequest.class);
        scene.pass(15 * Scene.SECOND - 1);
        assertEquals(List.of("calling 5550200"), scene.reported.lines());
        scene.pass(1);
        assertEquals(List.of("calling 5550200", "released 38"), scene.reported.lines());
    }

    @Test
    void hangingUpBeforeTheServiceIsGrantedAbortsTheRequest() {
        Scene scene = hungUpBeforeTheService();
        assertEquals(List.of("calling 5550200", "released 16"), scene.reported.lines());
        scene.releaseChannel();
        scene.expectNothing();
    }

    private static Scene hungUpBeforeTheService() {
        Scene scene = Scene.registered();
        scene.station.dial(Scene.OTHER);
        scene.expectFirst(CmServiceRequest.class);
        scene.station.hangUp();
        scene.expect(CmServiceAbort.class);
        return scene;
    }

    @Test
    void aGrantThatCrossesTheAbortGrantsNothing() {
        Scene scene = hungUpBeforeTheService();
        scene.station.dial(THIRD);
        scene.down(new CmServiceAccept());
        scene.expectNothing();
        scene.releaseChannel();
        scene.expectFirst(CmServiceRequest.class);
        scene.down(new CmServiceAccept());
        assertEquals(Optional.of(THIRD), scene.expect(Setup.class).called());
    }

    @Test
    void anAbortThatTheNetworkIgnoresIsOverAfterT3240() {
        Scene scene = hungUpBeforeTheService();
        scene.station.dial(THIRD);
        scene.pass(10 * Scene.SECOND - 1);
        scene.expectNothing();
        scene.pass(1);
        scene.expectReleaseIndication();
        scene.expectFirst(CmServiceRequest.class);
    }

    @Test
    void aLostLinkForgetsTheAbort() {
        Scene scene = hungUpBeforeTheService();
        scene.linkDown();
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        scene.releaseChannel();
        scene.station.dial(THIRD);
        scene.expectFirst(CmServiceRequest.class);
    }

    @Test
    void aRequestThatCrossesTheChannelsReleaseIsMadeAnew() {
        Scene scene = active();
        scene.station.hangUp();
        scene.expect(Disconnect.class);
        scene.down(new Release(TO_OWN, Optional.empty()));
        scene.expect(ReleaseComplete.class);
        scene.station.dial(THIRD);
        scene.expect(CmServiceRequest.class);
        scene.down(new ChannelRelease(0));
        scene.expectReleaseIndication();
        scene.expectFirst(CmServiceRequest.class);
        scene.down(new CmServiceAccept());
        assertEquals(Optional.of(THIRD), scene.expect(Setup.class).called());
        assertEquals(List.of("released 16", "calling 5550999"), scene.reported.lines());
    }

    @Test
    void aNumberDialledWhileTheOldCallIsClearedIsCalledNext() {
        Scene scene = active();
        scene.station.hangUp();
        scene.expect(Disconnect.class);
        assertTrue(scene.station.dial(THIRD));
        assertFalse(scene.station.dial(THIRD));
        scene.expectNothing();
        scene.down(new Release(TO_OWN, Optional.empty()));
        scene.expect(ReleaseComplete.class);
        scene.acceptService();
        assertEquals(
                new TransactionIdentifier(1, false), scene.expect(Setup.class).transaction());
        assertEquals(List.of("released 16", "calling 5550999"), scene.reported.lines());
    }

    @Test
    void aWaitingCallMayBeHungUpToo() {
        Scene scene = active();
        scene.station.hangUp();
        scene.station.dial(THIRD);
        assertTrue(scene.station.hangUp());
        assertEquals(List.of("released 16", "calling 5550999", "released 16"), scene.reported.lines());
    }

    @Test
    void t303EndsACallWithoutCallProceeding() {
        Scene scene = dialled();
        scene.pass(30 * Scene.SECOND - 1);
        scene.expectNothing();
        scene.pass(1);
        scene.expect(new Disconnect(OWN, Cause.RECOVERY_ON_TIMER_EXPIRY));
        assertEquals(List.of("calling 5550200", "released 102"), scene.reported.lines());
    }

    @Test
    void t310EndsACallThatProceedsToNothing() {
        Scene scene = dialled();
        scene.down(new CallProceeding(TO_OWN));
        scene.pass(30 * Scene.SECOND - 1);
        scene.expectNothing();
        scene.pass(1);
        scene.expect(new Disconnect(OWN, Cause.RECOVERY_ON_TIMER_EXPIRY));
    }

    @Test
    void progressAndAlertingStopT310() {
        Scene progressing = dialled();
        progressing.down(new CallProceeding(TO_OWN));
        progressing.down(new Progress(TO_OWN));
        progressing.pass(100 * Scene.SECOND);
        progressing.expectNothing();
        Scene alerted = dialled();
        alerted.down(new CallProceeding(TO_OWN));
        alerted.down(new Alerting(TO_OWN));
        alerted.pass(100 * Scene.SECOND);
        alerted.expectNothing();
    }

    @Test
    void t313EndsAnAnsweredCallThatIsNotAcknowledged() {
        Scene scene = ringing();
        scene.station.answer();
        scene.expect(Connect.class);
        scene.pass(30 * Scene.SECOND - 1);
        scene.expectNothing();
        scene.pass(1);
        scene.expect(new Disconnect(TO_THEIRS, Cause.RECOVERY_ON_TIMER_EXPIRY));
    }

    @Test
    void aSilentNetworkIsReleasedByT305AndTwiceT308() {
        Scene scene = active();
        scene.station.hangUp();
        scene.expect(Disconnect.class);
        scene.pass(30 * Scene.SECOND);
        scene.expect(new Release(OWN, Optional.empty()));
        scene.pass(30 * Scene.SECOND);
        scene.expect(new Release(OWN, Optional.empty()));
        assertEquals(MobileCallState.RELEASE_REQUEST, stateOf(scene));
        scene.pass(30 * Scene.SECOND);
        assertEquals(MobileCallState.NULL, stateOf(scene));
        assertEquals(List.of("released 16"), scene.reported.lines());
    }

    @Test
    void aLostLinkReleasesTheCallWithCause41() {
        Scene scene = active();
        scene.linkDown();
        assertEquals(List.of("released 41", "unregistered"), scene.reported.lines());
        scene.spoken.clear();
        scene.pass(Scene.SECOND);
        assertTrue(scene.spoken.isEmpty());
        assertEquals(MobileCallState.NULL, stateOf(scene));
    }

    @Test
    void aReleasedChannelTakesTheCallWithIt() {
        Scene scene = active();
        scene.releaseChannel();
        assertEquals(List.of("released 41"), scene.reported.lines());
        assertEquals(MobileCallState.NULL, stateOf(scene));
    }

    @Test
    void poweringOffInACallEndsItAndDetaches() {
        Scene scene = active();
        scene.station.powerOff();
        scene.expect(new Disconnect(OWN, Cause.NORMAL_CALL_CLEARING));
        scene.expectReleaseIndication();
        scene.expectFirst(ImsiDetachIndication.class);
        assertEquals(List.of("released 16", "unregistered"), scene.reported.lines());
    }

    @Test
    void messagesThatDoNotFitTheStateGetStatus98() {
        Scene scene = active();
        scene.down(new CallProceeding(TO_OWN));
        scene.expect(new Status(OWN, Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE, 10));
        scene.down(new Connect(TO_OWN));
        scene.expect(new Status(OWN, Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE, 10));
        assertEquals(MobileCallState.ACTIVE, stateOf(scene));
    }

    @Test
    void unknownMessagesGetStatus97() {
        Scene scene = active();
        scene.downHex("833f");
        scene.expect(new Status(OWN, Cause.MESSAGE_TYPE_NON_EXISTENT, 10));
        assertEquals(MobileCallState.ACTIVE, stateOf(scene));
    }

    @Test
    void aBrokenDisconnectStillDisconnects() {
        Scene scene = active();
        scene.downHex("8325");
        scene.expect(Release.class);
        assertEquals(List.of("released 96"), scene.reported.lines());
    }

    @Test
    void aBrokenSetupIsReleasedAtOnce() {
        Scene scene = Scene.registered();
        scene.page(Scene.TMSI);
        scene.expect(PagingResponse.class);
        scene.downHex("33050100");
        ReleaseComplete refusal = scene.expect(ReleaseComplete.class);
        assertEquals(TO_THEIRS, refusal.transaction());
        assertEquals(MobileCallState.NULL, stateOf(scene));
    }

    @Test
    void messagesOfAnUnknownTransactionAreReleasedWithCause81() {
        Scene scene = active();
        TransactionIdentifier unknown = new TransactionIdentifier(6, true);
        scene.down(new Alerting(unknown));
        scene.expect(new ReleaseComplete(unknown.answered(), Optional.of(Cause.INVALID_TRANSACTION_IDENTIFIER)));
        scene.down(new Release(unknown, Optional.empty()));
        scene.expect(new ReleaseComplete(unknown.answered(), Optional.of(Cause.INVALID_TRANSACTION_IDENTIFIER)));
        scene.down(new ReleaseComplete(unknown, Optional.empty()));
        scene.down(new Status(unknown, Cause.NORMAL_UNSPECIFIED, 0));
        scene.expectNothing();
        assertEquals(MobileCallState.ACTIVE, stateOf(scene));
    }

    @Test
    void anEnquiryIsAnsweredWithTheState() {
        Scene scene = dialled();
        scene.down(new StatusEnquiry(TO_OWN));
        scene.expect(new Status(OWN, Cause.RESPONSE_TO_STATUS_ENQUIRY, 1));
    }

    @Test
    void aNetworkThatKnowsOfNoCallEndsOurs() {
        Scene scene = active();
        scene.down(new Status(TO_OWN, Cause.NORMAL_UNSPECIFIED, 10));
        assertEquals(MobileCallState.ACTIVE, stateOf(scene));
        scene.down(new Status(TO_OWN, Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE, 0));
        assertEquals(MobileCallState.NULL, stateOf(scene));
        assertEquals(List.of("released 98"), scene.reported.lines());
    }

    @Test
    void oneCallAfterTheOtherUsesOneTransactionAfterTheOther() {
        Scene scene = Scene.registered();
        for (int call = 0; call < 8; call++) {
            scene.station.dial(Scene.OTHER);
            scene.acceptService();
            TransactionIdentifier own = scene.expect(Setup.class).transaction();
            assertEquals(call % 7, own.value());
            scene.down(new ReleaseComplete(own.answered(), Optional.of(Cause.USER_BUSY)));
            scene.releaseChannel();
        }
    }
}
