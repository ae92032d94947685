package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.msc.ActiveCall.CALLED_TRANSACTION;
import static simgsm.center.msc.TestMobile.OUR_CALL;

import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslMessage;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Layer3Message;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.RadioResource;
import simgsm.air.TransactionIdentifier;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallState;
import simgsm.center.subscriber.HomeRegister;

class CallTest {
    private final TestNetwork network = new TestNetwork();
    private TestMobile caller;
    private TestMobile called;

    /** 5550100 calls 5550200, which is paged. */
    private void dial() {
        caller = network.attach("5550100");
        called = network.attach("5550200");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
    }

    /** As {@link #dial}, up to ALERTING at both. */
    private void ringing() {
        dial();
        called.ring();
        caller.next(CallControl.Alerting.class);
    }

    private static byte[] speech(int sequence) {
        return new RtpPacket(RtpPacket.A_LAW, sequence, 160L * sequence, 0xcafef00dL, new byte[160]).encode();
    }

    private void assertCauseOfRefusal(Cause expected, TestMobile caller) {
        CallControl.Disconnect disconnect = caller.next(CallControl.Disconnect.class);
        assertEquals(expected, disconnect.cause());
        caller.tell(new CallControl.Release(OUR_CALL, Optional.empty()));
        caller.next(CallControl.ReleaseComplete.class);
        caller.leaveReleasedChannel();
        assertTrue(caller.hasNothing());
        assertTrue(network.exchange.calls().isEmpty());
    }

    @Test
    void aCallIsSetUpSpokenInAndCleared() {
        TestMobile caller = network.attach("5550100");
        TestMobile called = network.attach("5550200");

        // The caller dials; the called mobile is paged.
        caller.dial("5550200");
        assertEquals(
                OUR_CALL.answered(),
                caller.next(CallControl.CallProceeding.class).transaction());
        CallControl.Setup setup = called.takeSetup();
        assertEquals(TestNetwork.number("5550100"), setup.calling());
        assertEquals(new TransactionIdentifier(0, false), setup.transaction());

        // It rings.
        called.tell(new CallControl.CallConfirmed(CALLED_TRANSACTION));
        assertTrue(caller.hasNothing());
        called.tell(new CallControl.Alerting(CALLED_TRANSACTION));
        caller.next(CallControl.Alerting.class);

        // It is answered.
        called.tell(new CallControl.Connect(CALLED_TRANSACTION));
        called.next(CallControl.ConnectAcknowledge.class);
        caller.next(CallControl.Connect.class);
        assertEquals(List.of(CallProgress.INITIATED, CallProgress.ALERTING), network.callStates());
        caller.tell(new CallControl.ConnectAcknowledge(OUR_CALL));

        // They speak.
        caller.speak(speech(1));
        called.speak(speech(2));
        assertArrayEquals(speech(1), called.heard.get(0));
        assertArrayEquals(speech(2), caller.heard.get(0));

        // The caller hangs up.
        caller.hangUp(OUR_CALL);
        caller.leaveReleasedChannel();
        assertEquals(
                Cause.NORMAL_CALL_CLEARING,
                called.next(CallControl.Disconnect.class).cause());
        called.tell(new CallControl.Release(CALLED_TRANSACTION, Optional.empty()));
        called.next(CallControl.ReleaseComplete.class);
        called.leaveReleasedChannel();

        assertEquals(
                List.of(CallProgress.INITIATED, CallProgress.ALERTING, CallProgress.ACTIVE, CallProgress.RELEASED),
                network.callStates());
        assertTrue(network.exchange.calls().isEmpty());
        assertTrue(caller.hasNothing() && called.hasNothing());
    }

    @Test
    void theCalledPartyMayHangUpToo() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.called().hangUp(CALLED_TRANSACTION);
        call.called().leaveReleasedChannel();
        assertCauseOfRefusal(Cause.NORMAL_CALL_CLEARING, call.caller());
    }

    @Test
    void aModemThatConnectsWithoutAlertingIsConnected() {
        dial();
        called.takeSetup();
        called.tell(new CallControl.CallConfirmed(CALLED_TRANSACTION));
        called.tell(new CallControl.Connect(CALLED_TRANSACTION));
        caller.next(CallControl.Connect.class);
    }

    @Test
    void speechOfTheCalledPartyFollowsConnectAtOnce() {
        ringing();
        caller.speak(speech(0));
        called.speak(speech(0));
        assertTrue(called.heard.isEmpty() && caller.heard.isEmpty(), "a ringing call passes no speech");
        called.tell(new CallControl.Connect(CALLED_TRANSACTION));
        called.speak(speech(1));
        assertArrayEquals(speech(1), caller.heard.get(0));
    }

    @Test
    void everyKindOfSpeechPassesUnaltered() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        byte[] octets = new byte[33];
        new Random(1).nextBytes(octets);
        byte[] fullRate = new RtpPacket(RtpPacket.GSM_FULL_RATE, 7, 1120, 1, octets).encode();
        call.caller().speak(fullRate);
        call.called().speak(speech(1));
        call.called().speak(fullRate);
        assertArrayEquals(fullRate, call.called().heard.get(0));
        assertArrayEquals(speech(1), call.caller().heard.get(0));
        assertArrayEquals(fullRate, call.caller().heard.get(1));
    }

    @Test
    void speechEndsWithTheCall() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().tell(new CallControl.Disconnect(OUR_CALL, Cause.NORMAL_CALL_CLEARING));
        call.caller().speak(speech(1));
        call.called().speak(speech(1));
        assertTrue(call.called().heard.isEmpty() && call.caller().heard.isEmpty());
    }

    @Test
    void aNumberThatWasNeverSeenIsUnassignedCause1() {
        TestMobile caller = network.attach("5550100");
        caller.dial("5550999");
        assertEquals(
                Optional.of(Cause.UNASSIGNED_NUMBER),
                caller.next(CallControl.ReleaseComplete.class).cause());
        caller.leaveReleasedChannel();
        assertEquals(List.of(CallProgress.INITIATED, CallProgress.RELEASED), network.callStates());
    }

    @Test
    void aSetupWithoutAReadableNumberIsInvalidCause28() {
        TestMobile caller = network.attach("5550100");
        caller.requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
        // Called number *21#, N(SD) 1.
        caller.tellOctets("0345" + "0406600402000581" + "5e0391" + "2ab1");
        assertEquals(
                Optional.of(Cause.INVALID_NUMBER_FORMAT),
                caller.next(CallControl.ReleaseComplete.class).cause());
        caller.leaveReleasedChannel();
    }

    @Test
    void aSubscriberInACallIsBusyCause17() {
        network.activeCall("5550100", "5550200");
        TestMobile third = network.attach("5550101");
        third.dial("5550200");
        third.next(CallControl.CallProceeding.class);
        assertEquals(Cause.USER_BUSY, third.next(CallControl.Disconnect.class).cause());
    }

    @Test
    void aRingingSubscriberIsBusyToo() {
        TestMobile first = network.attach("5550100");
        TestMobile second = network.attach("5550101");
        TestMobile called = network.attach("5550200");
        first.dial("5550200");
        called.next(RslMessage.PagingCommand.class);
        second.dial("5550200");
        second.next(CallControl.CallProceeding.class);
        assertCauseOf(second, Cause.USER_BUSY);
    }

    private static void assertCauseOf(TestMobile mobile, Cause expected) {
        assertEquals(expected, mobile.next(CallControl.Disconnect.class).cause());
    }

    @Test
    void aCallToTheOwnNumberIsBusyCause17() {
        TestMobile caller = network.attach("5550100");
        caller.dial("5550100");
        caller.next(CallControl.CallProceeding.class);
        assertCauseOfRefusal(Cause.USER_BUSY, caller);
    }

    @Test
    void theCalledMobilesOwnBusyAnswerIsPassedOn() {
        dial();
        called.takeSetup();
        called.tell(new CallControl.ReleaseComplete(CALLED_TRANSACTION, Optional.of(Cause.USER_BUSY)));
        called.leaveReleasedChannel();
        assertCauseOfRefusal(Cause.USER_BUSY, caller);
    }

    @Test
    void aRejectionByTheCalledPartyIsPassedOnCause21() {
        ringing();
        called.tell(new CallControl.Disconnect(CALLED_TRANSACTION, Cause.CALL_REJECTED));
        called.next(CallControl.Release.class);
        assertCauseOfRefusal(Cause.CALL_REJECTED, caller);
    }

    @Test
    void aDetachedSubscriberIsAbsentCause27() {
        network.attach("5550200").vanish();
        TestMobile caller = network.attach("5550100");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
        assertCauseOfRefusal(Cause.DESTINATION_OUT_OF_ORDER, caller);
    }

    @Test
    void aPagingWithoutAnswerIsAbsentCause27() {
        dial();
        called.next(RslMessage.PagingCommand.class);
        network.passSeconds(3);
        called.next(RslMessage.PagingCommand.class);
        network.passSeconds(3);
        called.next(RslMessage.PagingCommand.class);
        assertTrue(caller.hasNothing());
        network.passSeconds(3);
        assertTrue(called.hasNothing());
        assertCauseOfRefusal(Cause.DESTINATION_OUT_OF_ORDER, caller);
    }

    @Test
    void pagingThatIsAnsweredAtTheSecondCallGoesOn() {
        dial();
        called.next(RslMessage.PagingCommand.class);
        network.passSeconds(3);
        called.takeSetup();
        network.passSeconds(10);
        called.tell(new CallControl.CallConfirmed(CALLED_TRANSACTION));
        called.tell(new CallControl.Alerting(CALLED_TRANSACTION));
        caller.next(CallControl.Alerting.class);
    }

    @Test
    void anyFirstMessageAnswersPaging() {
        dial();
        called.next(RslMessage.PagingCommand.class);
        called.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        called.next(CallControl.Setup.class);
    }

    @Test
    void aMobileThatIsOnTheAirAlreadyIsNotPaged() {
        TestMobile caller = network.attach("5550100");
        TestMobile called = network.attach("5550200");
        called.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        caller.dial("5550200");
        called.next(CallControl.Setup.class);
    }

    @Test
    void aMobileThatIgnoresSetupIsNotRespondingCause18() {
        dial();
        called.takeSetup();
        network.passSeconds(29);
        assertTrue(caller.hasNothing());
        network.passSeconds(1);
        assertCauseOf(called, Cause.RECOVERY_ON_TIMER_EXPIRY);
        assertCauseOfRefusal(Cause.NO_USER_RESPONDING, caller);
    }

    @Test
    void theTimeForAnAnswerToSetupIsTheNetworksChoice() {
        TestNetwork patient = new TestNetwork(new ExchangeSettings(
                "SimGSM",
                new SplittableRandom(1),
                Instant.EPOCH,
                HomeRegister.OPEN,
                Optional.empty(),
                false,
                Locale.ENGLISH,
                false,
                TimeUnit.SECONDS.toNanos(8),
                Optional.empty(),
                HandoverAlgorithm.STANDARD));
        TestMobile caller = patient.attach("5550100");
        TestMobile called = patient.attach("5550200");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
        called.takeSetup();
        patient.passSeconds(7);
        assertTrue(caller.hasNothing());
        patient.passSeconds(1);
        assertCauseOfRefusal(Cause.NO_USER_RESPONDING, caller);
    }

    @Test
    void aMobileThatConfirmsAndNeverRingsIsNotRespondingCause18() {
        dial();
        called.takeSetup();
        called.tell(new CallControl.CallConfirmed(CALLED_TRANSACTION));
        network.passSeconds(29);
        assertTrue(caller.hasNothing());
        network.passSeconds(1);
        assertCauseOf(called, Cause.RECOVERY_ON_TIMER_EXPIRY);
        assertCauseOfRefusal(Cause.NO_USER_RESPONDING, caller);
    }

    @Test
    void aCallWithoutAnAnswerEndsAfterThreeMinutesCause19() {
        ringing();
        called.received.clear();
        network.passSeconds(179);
        assertTrue(caller.hasNothing());
        network.passSeconds(1);
        assertCauseOf(called, Cause.RECOVERY_ON_TIMER_EXPIRY);
        assertCauseOfRefusal(Cause.USER_ALERTING_NO_ANSWER, caller);
    }

    @Test
    void aCallWithoutConnectAcknowledgeIsCleared() {
        ringing();
        called.tell(new CallControl.Connect(CALLED_TRANSACTION));
        called.next(CallControl.ConnectAcknowledge.class);
        caller.received.clear();
        network.passSeconds(29);
        assertTrue(called.hasNothing());
        network.passSeconds(1);
        assertCauseOf(called, Cause.RECOVERY_ON_TIMER_EXPIRY);
        assertCauseOf(caller, Cause.RECOVERY_ON_TIMER_EXPIRY);
    }

    @Test
    void aDisconnectThatIsNotAnsweredBecomesReleaseTwiceAndThenNothing() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().hangUp(OUR_CALL);
        TestMobile called = call.called();
        called.next(CallControl.Disconnect.class);
        for (int i = 0; i < 2; i++) {
            network.passSeconds(30);
            called.next(CallControl.Release.class);
        }
        network.passSeconds(30);
        called.next(RadioResource.ChannelRelease.class);
    }

    @Test
    void twoDisconnectsThatCrossEndInPeace() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().hangUp(OUR_CALL);
        call.called().next(CallControl.Disconnect.class);
        call.called().tell(new CallControl.Disconnect(CALLED_TRANSACTION, Cause.NORMAL_CALL_CLEARING));
        call.called().next(CallControl.Release.class);
        call.called().tell(new CallControl.ReleaseComplete(CALLED_TRANSACTION, Optional.empty()));
        call.called().leaveReleasedChannel();
        assertEquals(
                1,
                network.callStates().stream()
                        .filter(CallProgress.RELEASED::equals)
                        .count());
    }

    @Test
    void aMobileThatRepeatsDisconnectInsteadOfReleaseCompleteIsWaitedFor() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().tell(new CallControl.Disconnect(OUR_CALL, Cause.NORMAL_CALL_CLEARING));
        call.caller().next(CallControl.Release.class);
        call.caller().tell(new CallControl.Disconnect(OUR_CALL, Cause.NORMAL_CALL_CLEARING));
        assertTrue(call.caller().hasNothing());
        call.caller().tell(new CallControl.Release(OUR_CALL, Optional.empty()));
        call.caller().leaveReleasedChannel();
    }

    @Test
    void aHangUpWhileTheOtherIsPagedStopsThePaging() {
        dial();
        called.next(RslMessage.PagingCommand.class);
        caller.hangUp(OUR_CALL);
        caller.leaveReleasedChannel();
        network.passSeconds(20);
        assertTrue(called.hasNothing());
        // The late answer finds nothing to do.
        called.establish(new RadioResource.PagingResponse(MobilityManagement.NO_KEY, called.identity()));
        called.leaveReleasedChannel();
    }

    @Test
    void aLostLinkInAnActiveCallIsATemporaryFailureCause41() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.called().vanish();
        assertCauseOfRefusal(Cause.TEMPORARY_FAILURE, call.caller());

        ActiveCall other = new TestNetwork().activeCall("5550100", "5550200");
        other.caller().vanish();
        assertCauseOf(other.called(), Cause.TEMPORARY_FAILURE);
    }

    @Test
    void aCalledMobileThatVanishesWhileRingingIsOutOfOrderCause27() {
        ringing();
        called.vanish();
        assertCauseOfRefusal(Cause.DESTINATION_OUT_OF_ORDER, caller);
    }

    @Test
    void aMobileThatDetachesInACallLosesIt() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.called()
                .tell(new MobilityManagement.ImsiDetachIndication(call.called().identity()));
        call.called().next(RadioResource.ChannelRelease.class);
        assertCauseOfRefusal(Cause.TEMPORARY_FAILURE, call.caller());
    }

    @Test
    void aNewRadioConnectionMeansThatTheOldOneAndItsCallAreLost() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.called().requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
        assertCauseOfRefusal(Cause.TEMPORARY_FAILURE, call.caller());
    }

    @Test
    void statusEnquiryIsAnsweredWithTheCallState() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().tell(new CallControl.StatusEnquiry(OUR_CALL));
        CallControl.Status status = call.caller().next(CallControl.Status.class);
        assertEquals(Cause.RESPONSE_TO_STATUS_ENQUIRY, status.cause());
        assertEquals(NetworkCallState.ACTIVE.code(), status.callState());
    }

    @Test
    void aMobileThatNoLongerKnowsTheCallLosesIt() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.called().tell(new CallControl.Status(CALLED_TRANSACTION, Cause.RESPONSE_TO_STATUS_ENQUIRY, 0));
        call.called().leaveReleasedChannel();
        call.caller().next(CallControl.Disconnect.class);
    }

    @Test
    void aStatusThatComplainsChangesNothing() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.called().tell(new CallControl.Status(CALLED_TRANSACTION, Cause.MESSAGE_TYPE_NON_EXISTENT, 10));
        assertTrue(call.called().hasNothing() && call.caller().hasNothing());
    }

    @Test
    void messagesOfACallThatIsNotThereAreAnsweredWithCause81() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        TransactionIdentifier unknown = new TransactionIdentifier(5, false);
        for (Layer3Message message : List.<Layer3Message>of(
                new CallControl.Connect(unknown),
                new CallControl.Disconnect(unknown, Cause.NORMAL_CALL_CLEARING),
                new CallControl.Release(unknown, Optional.empty()),
                new CallControl.Status(unknown, Cause.NORMAL_UNSPECIFIED, 10))) {
            call.caller().tell(message);
            assertEquals(
                    Optional.of(Cause.INVALID_TRANSACTION_IDENTIFIER),
                    call.caller().next(CallControl.ReleaseComplete.class).cause());
        }
        call.caller().tell(new CallControl.ReleaseComplete(unknown, Optional.empty()));
        call.caller().tell(new CallControl.Status(unknown, Cause.NORMAL_UNSPECIFIED, 0));
        call.caller().tell(new CallControl.Setup(OUR_CALL, Optional.empty(), TestNetwork.number("5550200")));
        assertTrue(call.caller().hasNothing(), "neither these nor a second SETUP of the same call are answered");
    }

    @Test
    void aSetupWithoutServiceIsRefusedWithCause98() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller()
                .tell(new CallControl.Setup(
                        new TransactionIdentifier(1, false), Optional.empty(), TestNetwork.number("5550200")));
        assertEquals(
                Optional.of(Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE),
                call.caller().next(CallControl.ReleaseComplete.class).cause());
    }

    @Test
    void anAbortedServiceGivesTheChannelBack() {
        TestMobile caller = network.attach("5550100");
        caller.requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
        caller.tell(new MobilityManagement.CmServiceAbort());
        caller.leaveReleasedChannel();
        assertTrue(caller.hasNothing());
        caller.dial("5550100");
        assertTrue(network.callStates().contains(CallProgress.INITIATED));
    }

    @Test
    void twoSubscribersThatCallEachOtherAtOnceAreNotStuck() {
        TestMobile one = network.attach("5550100");
        TestMobile other = network.attach("5550200");
        one.dial("5550200");
        one.next(CallControl.CallProceeding.class);
        other.next(RslMessage.PagingCommand.class);
        // The other's own request is already under way.
        other.requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
        other.next(CallControl.Setup.class);
        other.tell(new CallControl.Setup(OUR_CALL, Optional.empty(), TestNetwork.number("5550100")));
        other.next(CallControl.CallProceeding.class);
        assertCauseOf(other, Cause.USER_BUSY);
        other.tell(new CallControl.ReleaseComplete(CALLED_TRANSACTION, Optional.of(Cause.USER_BUSY)));
        assertCauseOf(one, Cause.USER_BUSY);
        assertTrue(network.exchange.calls().isEmpty());
    }

    @Test
    void theCallEventsNameBothParties() {
        network.activeCall("5550100", "5550200");
        assertEquals(
                new ExchangeEvent.CallChanged(
                        1, new Msisdn("5550100"), new Msisdn("5550200"), CallProgress.ACTIVE, Optional.empty()),
                network.events.get(network.events.size() - 1));
    }
}
