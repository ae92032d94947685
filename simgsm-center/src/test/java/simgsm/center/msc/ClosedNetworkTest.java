package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.RadioResource;
import simgsm.air.RejectCause;
import simgsm.air.RelayMessage;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.Tmsi;
import simgsm.center.msc.mobility.CardAuthentication;
import simgsm.center.subscriber.HomeRegister;
import simgsm.octets.OctetString;
import simgsm.sim.SimCard;
import simgsm.sim.Subscription;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;

/** A network for listed cards alone: who comes in, how he proves himself, whom he reaches. */
class ClosedNetworkTest {
    private static final SimCard ANA = card("5550100", "262420000000017", 1);
    private static final SimCard EVA = card("5550101", "001010000000042", 2);
    private static final SimCard BARRED = card("5550102", "001010000000043", 3);
    private static final Imei STOLEN = new Imei("490154203237518");

    private final TestNetwork network = new TestNetwork(HomeRegister.closed(
            List.of(new Subscription(ANA, false), new Subscription(EVA, false), new Subscription(BARRED, true)),
            List.of(STOLEN)));

    private static SimCard card(String number, String imsi, int key) {
        OctetString k = OctetString.ofHex(String.format("%032x", key));
        return new SimCard(new Imsi(imsi), new Msisdn(number), k, k);
    }

    private TestMobile connect() {
        TestMobile mobile = network.connect("1");
        mobile.received.clear();
        return mobile;
    }

    private TestMobile attach(SimCard card) {
        TestMobile mobile = connect();
        attach(mobile, card, card.imsi());
        return mobile;
    }

    private static void attach(TestMobile mobile, SimCard card, MobileIdentity identity) {
        mobile.requestUpdate(identity);
        mobile.prove(card);
        assertEquals(
                MobileIdentity.Type.IMEI,
                mobile.next(MobilityManagement.IdentityRequest.class).identityType());
        mobile.tell(new MobilityManagement.IdentityResponse(mobile.imei));
        assertTrue(mobile.next(MobilityManagement.LocationUpdatingAccept.class)
                .newIdentity()
                .isPresent());
        mobile.tell(new MobilityManagement.TmsiReallocationComplete());
        mobile.next(MobilityManagement.MmInformation.class);
        mobile.leaveReleasedChannel();
    }

    @Test
    void aListedCardThatProvesItselfRegistersUnderItsNumber() {
        TestMobile mobile = attach(ANA);
        assertEquals(List.of(new ExchangeEvent.Attached(ANA.number())), network.events);
        assertTrue(mobile.hasNothing());
    }

    @Test
    void allListedNumbersAreKnownFromTheStartAndNoOthers() {
        assertEquals(
                List.of(ANA.number(), EVA.number(), BARRED.number()),
                network.exchange.subscribers().stream()
                        .map(each -> each.number())
                        .toList());
    }

    @Test
    void theSnapshotMarksBarredSubscribers() {
        attach(ANA);
        assertEquals(
                List.of("5550100 true false", "5550101 false false", "5550102 false true"),
                network.exchange.snapshot().subscribers().stream()
                        .map(row -> row.number() + " " + row.attached() + " " + row.barred())
                        .toList());
    }

    @Test
    void noTwoChallengesAreTheSame() {
        TestMobile mobile = connect();
        mobile.requestUpdate(ANA.imsi());
        OctetString first = mobile.prove(ANA).rand();
        mobile.requestUpdate(ANA.imsi());
        mobile.next(MobilityManagement.IdentityRequest.class);
        assertNotEquals(first, mobile.prove(ANA).rand());
    }

    @Test
    void aCardWithAnotherKeyIsRejectedAndNothingIsGivenAway() {
        TestMobile mobile = connect();
        mobile.requestUpdate(ANA.imsi());
        mobile.prove(EVA);
        mobile.next(MobilityManagement.AuthenticationReject.class);
        mobile.leaveReleasedChannel();
        assertTrue(mobile.hasNothing());
        assertTrue(network.events.isEmpty());
    }

    @Test
    void aCardWithoutAKeyIsRejected() {
        TestMobile mobile = connect();
        mobile.requestUpdate(ANA.imsi());
        mobile.next(MobilityManagement.AuthenticationRequest.class);
        mobile.tell(new MobilityManagement.AuthenticationFailure(RejectCause.MAC_FAILURE, Optional.empty()));
        mobile.next(MobilityManagement.AuthenticationReject.class);
        mobile.leaveReleasedChannel();
    }

    @Test
    void aCardThatIsNotListedIsRejectedWithCause2() {
        assertEquals(RejectCause.IMSI_UNKNOWN_IN_HLR, rejectionOf(Imsi.ofOpenNumber(new Msisdn("5550100"))));
        assertTrue(network.events.isEmpty());
    }

    private RejectCause rejectionOf(Imsi imsi) {
        TestMobile mobile = connect();
        mobile.requestUpdate(imsi);
        RejectCause cause =
                mobile.next(MobilityManagement.LocationUpdatingReject.class).cause();
        mobile.leaveReleasedChannel();
        return cause;
    }

    @Test
    void aBarredCardIsRejectedWithCause11OnlyOnceItHasProvedItself() {
        TestMobile mobile = connect();
        mobile.requestUpdate(BARRED.imsi());
        mobile.prove(BARRED);
        assertEquals(
                RejectCause.PLMN_NOT_ALLOWED,
                mobile.next(MobilityManagement.LocationUpdatingReject.class).cause());
        mobile.leaveReleasedChannel();
        assertTrue(network.events.isEmpty());
    }

    @Test
    void barredEquipmentIsRejectedWithCause6WhateverItsLastDigit() {
        for (String digits : List.of("490154203237518", "490154203237510")) {
            TestMobile mobile = connect();
            mobile.requestUpdate(ANA.imsi());
            mobile.prove(ANA);
            mobile.next(MobilityManagement.IdentityRequest.class);
            mobile.tell(new MobilityManagement.IdentityResponse(new Imei(digits)));
            assertEquals(
                    RejectCause.ILLEGAL_ME,
                    mobile.next(MobilityManagement.LocationUpdatingReject.class).cause());
            mobile.leaveReleasedChannel();
        }
        assertTrue(network.events.isEmpty());
    }

    @Test
    void anOpenNetworkBarsEquipmentToo() {
        TestNetwork open = new TestNetwork(HomeRegister.open(List.of(STOLEN)));
        TestMobile mobile = open.connect("5550100", STOLEN);
        mobile.received.clear();
        mobile.requestUpdate(mobile.imsi);
        mobile.next(MobilityManagement.IdentityRequest.class);
        mobile.tell(new MobilityManagement.IdentityResponse(mobile.imei));
        assertEquals(
                RejectCause.ILLEGAL_ME,
                mobile.next(MobilityManagement.LocationUpdatingReject.class).cause());
    }

    @Test
    void aChallengeUnansweredFor12SecondsLosesItsChannel() {
        TestMobile mobile = connect();
        mobile.requestUpdate(ANA.imsi());
        mobile.next(MobilityManagement.AuthenticationRequest.class);
        network.passSeconds(11);
        assertTrue(mobile.hasNothing());
        network.passSeconds(1);
        mobile.leaveReleasedChannel();
        assertTrue(network.events.isEmpty());
    }

    @Test
    void anAnswerAfterTheChannelsReleaseOpensNothing() {
        TestMobile mobile = connect();
        mobile.requestUpdate(ANA.imsi());
        MobilityManagement.AuthenticationRequest request = mobile.next(MobilityManagement.AuthenticationRequest.class);
        network.passSeconds(12);
        mobile.tell(new MobilityManagement.AuthenticationResponse(
                ANA.vector(request.rand()).sres()));
        mobile.leaveReleasedChannel();
        assertTrue(mobile.hasNothing());
        assertTrue(network.events.isEmpty());
    }

    /** A message that was long on its way down is answered on the next radio connection. */
    @Test
    void aLateAnswerToAChallengeThatWasGivenUpIsPassedOverAndTheRightOneCounts() {
        TestMobile mobile = attach(ANA);
        requestService(mobile, MobilityManagement.NO_KEY);
        OctetString first =
                mobile.next(MobilityManagement.AuthenticationRequest.class).rand();
        mobile.leaveChannel();
        requestService(mobile, MobilityManagement.NO_KEY);
        mobile.tell(
                new MobilityManagement.AuthenticationResponse(ANA.vector(first).sres()));
        mobile.prove(ANA);
        abandonService(mobile);
        assertEquals(1, network.events.size(), "still attached");
    }

    @Test
    void theSecondTimeATemporaryIdentityIsEnough() {
        TestMobile mobile = attach(ANA);
        attach(mobile, ANA, mobile.temporaryIdentity.orElseThrow());
        assertEquals(1, network.events.size());
    }

    @Test
    void aTemporaryIdentityOfAnotherSubscriberLeadsToTheRealCard() {
        Tmsi anas = (Tmsi) attach(ANA).temporaryIdentity.orElseThrow();
        TestMobile eva = connect();
        eva.requestUpdate(anas);
        eva.prove(EVA);
        assertEquals(
                MobileIdentity.Type.IMSI,
                eva.next(MobilityManagement.IdentityRequest.class).identityType());
        eva.tell(new MobilityManagement.IdentityResponse(EVA.imsi()));
        eva.prove(EVA);
        eva.next(MobilityManagement.IdentityRequest.class);
        eva.tell(new MobilityManagement.IdentityResponse(eva.imei));
        eva.next(MobilityManagement.LocationUpdatingAccept.class);
    }

    @Test
    void whoeverStillClaimsTheCardThatHeCouldNotProveIsRejected() {
        Tmsi anas = (Tmsi) attach(ANA).temporaryIdentity.orElseThrow();
        TestMobile eva = connect();
        eva.requestUpdate(anas);
        eva.prove(EVA);
        eva.next(MobilityManagement.IdentityRequest.class);
        eva.tell(new MobilityManagement.IdentityResponse(ANA.imsi()));
        eva.next(MobilityManagement.AuthenticationReject.class);
        eva.leaveReleasedChannel();
    }

    @Test
    void aCardThatFailsWhereItWasRegisteredIsRegisteredNoLonger() {
        TestMobile mobile = attach(ANA);
        mobile.requestUpdate(ANA.imsi());
        mobile.prove(EVA);
        mobile.next(MobilityManagement.AuthenticationReject.class);
        assertEquals(new ExchangeEvent.Detached(ANA.number()), network.events.get(1));
    }

    // Services.

    private static void requestService(TestMobile mobile, int keySequence) {
        mobile.establish(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL, keySequence, mobile.identity()));
    }

    private static void abandonService(TestMobile mobile) {
        mobile.next(MobilityManagement.CmServiceAccept.class);
        mobile.tell(new MobilityManagement.CmServiceAbort());
        mobile.leaveReleasedChannel();
    }

    @Test
    void aServiceUnderTheAgreedKeyIsGrantedTenTimesAndThenForANewProof() {
        TestMobile mobile = connect();
        mobile.requestUpdate(ANA.imsi());
        int agreed = mobile.prove(ANA).keySequence();
        mobile.next(MobilityManagement.IdentityRequest.class);
        mobile.tell(new MobilityManagement.IdentityResponse(mobile.imei));
        mobile.next(MobilityManagement.LocationUpdatingAccept.class);
        mobile.tell(new MobilityManagement.TmsiReallocationComplete());
        mobile.next(MobilityManagement.MmInformation.class);
        mobile.leaveReleasedChannel();
        for (int use = 0; use < CardAuthentication.MAX_KEY_USES; use++) {
            requestService(mobile, agreed);
            abandonService(mobile);
        }
        requestService(mobile, agreed);
        assertNotEquals(agreed, mobile.prove(ANA).keySequence());
        abandonService(mobile);
    }

    @Test
    void aServiceUnderAnotherKeyNeedsAProof() {
        TestMobile mobile = attach(ANA);
        requestService(mobile, MobilityManagement.NO_KEY);
        mobile.prove(ANA);
        abandonService(mobile);
        assertEquals(1, network.events.size());
    }

    @Test
    void aFailedAuthenticationForAServiceDetaches() {
        TestMobile mobile = attach(ANA);
        requestService(mobile, MobilityManagement.NO_KEY);
        mobile.prove(EVA);
        mobile.next(MobilityManagement.AuthenticationReject.class);
        mobile.leaveReleasedChannel();
        assertEquals(new ExchangeEvent.Detached(ANA.number()), network.events.get(1));
    }

    @Test
    void whileAProofIsAwaitedNothingElseIsServedAndTheProofStillCounts() {
        TestMobile mobile = attach(ANA);
        mobile.requestUpdate(ANA.imsi());
        MobilityManagement.AuthenticationRequest request = mobile.next(MobilityManagement.AuthenticationRequest.class);
        mobile.tell(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.SHORT_MESSAGE, request.keySequence(), mobile.identity()));
        assertEquals(
                RejectCause.MESSAGE_NOT_COMPATIBLE_WITH_STATE,
                mobile.next(MobilityManagement.CmServiceReject.class).cause());
        mobile.tell(new MobilityManagement.CmServiceAbort());
        mobile.tell(mobile.responseOf(ANA));
        mobile.next(MobilityManagement.IdentityRequest.class);
        mobile.tell(new MobilityManagement.IdentityResponse(mobile.imei));
        mobile.next(MobilityManagement.LocationUpdatingAccept.class);
    }

    @Test
    void aMobileThatDetachesDuringItsProofLeavesNothingBehind() {
        TestMobile mobile = attach(ANA);
        mobile.requestUpdate(ANA.imsi());
        mobile.next(MobilityManagement.AuthenticationRequest.class);
        mobile.tell(new MobilityManagement.ImsiDetachIndication(mobile.identity()));
        mobile.leaveReleasedChannel();
        assertEquals(new ExchangeEvent.Detached(ANA.number()), network.events.get(1));
        attach(mobile, ANA, ANA.imsi());
    }

    @Test
    void aRequestTakenBackDuringTheProofReleasesTheChannel() {
        TestMobile mobile = attach(ANA);
        requestService(mobile, MobilityManagement.NO_KEY);
        mobile.next(MobilityManagement.AuthenticationRequest.class);
        mobile.tell(new MobilityManagement.CmServiceAbort());
        mobile.leaveReleasedChannel();
        assertTrue(mobile.hasNothing());
    }

    // Whom one reaches.

    private Optional<Cause> releaseCauseOfCallTo(TestMobile caller, String number) {
        requestService(caller, MobilityManagement.NO_KEY);
        caller.prove(ANA);
        caller.next(MobilityManagement.CmServiceAccept.class);
        caller.tell(new CallControl.Setup(TestMobile.OUR_CALL, Optional.empty(), Optional.of(new Msisdn(number))));
        Object answer = caller.received.peek();
        if (answer instanceof CallControl.CallProceeding) {
            caller.next(CallControl.CallProceeding.class);
            return Optional.of(caller.next(CallControl.Disconnect.class).cause());
        }
        return caller.next(CallControl.ReleaseComplete.class).cause();
    }

    @Test
    void aCallToAnUnassignedOrBarredNumberIsCause1AndToAnAbsentOne27() {
        assertEquals(Optional.of(Cause.UNASSIGNED_NUMBER), releaseCauseOfCallTo(attach(ANA), "5559999"));
        network.everybodyVanishes();
        assertEquals(Optional.of(Cause.UNASSIGNED_NUMBER), releaseCauseOfCallTo(attach(ANA), "5550102"));
        network.everybodyVanishes();
        assertEquals(Optional.of(Cause.DESTINATION_OUT_OF_ORDER), releaseCauseOfCallTo(attach(ANA), "5550101"));
    }

    private static RelayMessage answerToMessage(TestMobile sender, int transaction, String to) {
        sender.establish(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.SHORT_MESSAGE, MobilityManagement.NO_KEY, sender.identity()));
        sender.prove(ANA);
        sender.next(MobilityManagement.CmServiceAccept.class);
        SubmitTpdu submit = new SubmitTpdu(
                false,
                false,
                false,
                transaction,
                SmsAddress.of(new Msisdn(to)),
                0,
                Optional.empty(),
                UserData.of("hi"));
        sender.sendMessage(transaction, transaction, TpduCodec.encode(submit));
        sender.next(ShortMessageControl.CpAck.class);
        ShortMessageControl.CpData data = sender.next(ShortMessageControl.CpData.class);
        sender.tell(new ShortMessageControl.CpAck(data.transaction().answered()));
        sender.leaveReleasedChannel();
        return data.relay();
    }

    @Test
    void aMessageToAnUnassignedOrBarredNumberIsRefusedWithRpCause1() {
        TestMobile sender = attach(ANA);
        assertEquals(new RelayMessage.RpError(1, RpCause.UNASSIGNED_NUMBER), answerToMessage(sender, 1, "5559999"));
        assertEquals(new RelayMessage.RpError(2, RpCause.UNASSIGNED_NUMBER), answerToMessage(sender, 2, "5550102"));
        assertTrue(answerToMessage(sender, 3, "5550101") instanceof RelayMessage.RpAck, "absent, so kept");
        assertEquals(1, network.exchange.shortMessages().waitingCount());
    }

    @Test
    void aMessageCarriesTheNumberOfTheCardWhateverThePhoneSays() {
        TestMobile sender = attach(ANA);
        answerToMessage(sender, 1, "5550101");
        assertEquals(
                ANA.number(),
                network.exchange.shortMessages().messages().waiting().get(0).from());
    }

    @Test
    void pagingIsByTheTemporaryIdentity() {
        TestMobile eva = attach(EVA);
        answerToMessage(attach(ANA), 1, "5550101");
        assertEquals(
                eva.temporaryIdentity.orElseThrow(),
                eva.next(RslMessage.PagingCommand.class).identity());
        eva.establish(new RadioResource.PagingResponse(MobilityManagement.NO_KEY, eva.identity()));
        assertFalse(eva.takeMessage().length() == 0);
    }
}
