package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl.Alerting;
import simgsm.air.CallControl.CallConfirmed;
import simgsm.air.CallControl.CallProceeding;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.ConnectAcknowledge;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.CallControl.Facility;
import simgsm.air.CallControl.Hold;
import simgsm.air.CallControl.HoldAcknowledge;
import simgsm.air.CallControl.ReleaseComplete;
import simgsm.air.CallControl.Retrieve;
import simgsm.air.CallControl.RetrieveAcknowledge;
import simgsm.air.CallControl.Setup;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simgsm.ss.NotifySs;

/** HOLD and RETRIEVE with a network that answers late, or at a bad moment, and that tells of the other party's hold. */
class HoldAnswersTest {
    private static final TransactionIdentifier OWN = new TransactionIdentifier(0, false);
    private static final TransactionIdentifier TO_OWN = OWN.answered();
    private static final TransactionIdentifier THEIRS = new TransactionIdentifier(3, false);
    private static final Msisdn THIRD = new Msisdn("5550999");
    private static final long EXPIRED = TimeUnit.SECONDS.toNanos(10);

    private final Scene scene =
            Scene.registered(new StationOptions(SpeechCodec.Kind.A_LAW, CallAudioListener.NONE, true));

    HoldAnswersTest() {
        scene.station.dial(Scene.OTHER);
        scene.acceptService();
        scene.expect(new Setup(OWN, Optional.empty(), Optional.of(Scene.OTHER)));
        scene.down(new CallProceeding(TO_OWN));
        scene.down(new Alerting(TO_OWN));
        scene.down(new Connect(TO_OWN));
        scene.expect(new ConnectAcknowledge(OWN));
        scene.reported.clear();
    }

    private List<String> news() {
        List<String> news = scene.reported.lines();
        scene.reported.clear();
        return news;
    }

    /** Speech keeps the call alive, whose far end would count as silent. */
    private void untilExpiry() {
        for (long passed = 0; passed < EXPIRED; passed += TimeUnit.SECONDS.toNanos(1)) {
            byte[] silence = new byte[160];
            scene.frame(IpaFrame.SPEECH, new RtpPacket(RtpPacket.A_LAW, 1, 0, 77, silence).encode());
            scene.pass(TimeUnit.SECONDS.toNanos(1));
        }
    }

    private void held() {
        assertTrue(scene.station.hold());
        scene.expect(new Hold(OWN));
        scene.down(new HoldAcknowledge(TO_OWN));
        assertEquals(List.of("held 5550200"), news());
    }

    private void waiting() {
        scene.down(new Setup(THEIRS, Optional.of(THIRD), Optional.empty()));
        scene.expect(new CallConfirmed(THEIRS.answered(), Optional.of(Cause.USER_BUSY)));
        scene.expect(new Alerting(THEIRS.answered()));
        assertEquals(List.of("waiting 5550999"), news());
    }

    private void twoCalls() {
        waiting();
        assertTrue(scene.station.hold());
        scene.expect(new Hold(OWN));
        scene.down(new HoldAcknowledge(TO_OWN));
        scene.expect(new Connect(THEIRS.answered()));
        scene.down(new ConnectAcknowledge(THEIRS));
        assertEquals(List.of("held 5550200", "connected 5550999"), news());
    }

    @Test
    void aCallThatTheNetworkHoldsTooLateIsHeldOnBothSides() {
        assertTrue(scene.station.hold());
        scene.expect(new Hold(OWN));
        untilExpiry();
        assertEquals(List.of("hold refused"), news());
        scene.down(new HoldAcknowledge(TO_OWN));
        assertEquals(List.of("held 5550200"), news());
        assertTrue(scene.station.hold());
        scene.expect(new Retrieve(OWN));
        scene.down(new RetrieveAcknowledge(TO_OWN));
        assertEquals(List.of("retrieved 5550200"), news());
    }

    /** The user was told that the first call is not held, and has not asked again to answer the waiting one. */
    @Test
    void aCallThatWaitsRingsWhenTheNetworkHoldsTheActiveOneTooLate() {
        waiting();
        assertTrue(scene.station.hold());
        scene.expect(new Hold(OWN));
        untilExpiry();
        assertEquals(List.of("hold refused"), news());
        scene.down(new HoldAcknowledge(TO_OWN));
        scene.expectNothing();
        assertEquals(List.of("held 5550200", "ringing 5550999"), news());
        assertTrue(scene.station.answer());
        scene.expect(new Connect(THEIRS.answered()));
    }

    @Test
    void aCallThatBeginsToWaitAfterTheRequestToHoldRings() {
        assertTrue(scene.station.hold());
        scene.expect(new Hold(OWN));
        waiting();
        scene.down(new HoldAcknowledge(TO_OWN));
        scene.expectNothing();
        assertEquals(List.of("held 5550200", "ringing 5550999"), news());
        assertTrue(scene.station.hangUp());
        scene.expect(new Disconnect(THEIRS.answered(), Cause.CALL_REJECTED));
    }

    @Test
    void aCallThatTheNetworkGivesBackTooLateIsActiveOnBothSides() {
        held();
        assertTrue(scene.station.hold());
        scene.expect(new Retrieve(OWN));
        scene.pass(EXPIRED);
        assertEquals(List.of("hold refused"), news());
        scene.down(new RetrieveAcknowledge(TO_OWN));
        assertEquals(List.of("retrieved 5550200"), news());
    }

    @Test
    void aCallThatIsGivenBackWhileAnotherIsDialledEnds() {
        held();
        assertTrue(scene.station.hold());
        scene.expect(new Retrieve(OWN));
        scene.pass(EXPIRED);
        assertTrue(scene.station.dial(THIRD));
        TransactionIdentifier dialled = new TransactionIdentifier(1, false);
        scene.acceptService();
        scene.expect(new Setup(dialled, Optional.empty(), Optional.of(THIRD)));
        news();
        scene.down(new RetrieveAcknowledge(TO_OWN));
        scene.expect(new Disconnect(OWN, Cause.NORMAL_CALL_CLEARING));
        assertEquals(List.of("held over 16"), news());
    }

    @Test
    void callsThatTheNetworkExchangesTooLateAreExchangedOnBothSides() {
        twoCalls();
        assertTrue(scene.station.hold());
        scene.expect(new Hold(THEIRS.answered()));
        scene.expect(new Retrieve(OWN));
        untilExpiry();
        assertEquals(List.of("hold refused"), news());
        scene.down(new HoldAcknowledge(THEIRS));
        assertEquals(List.of(), news());
        scene.down(new RetrieveAcknowledge(TO_OWN));
        assertEquals(List.of("held 5550999", "retrieved 5550200"), news());
    }

    @Test
    void anotherCallIsRefusedWhileTheHeldOneIsGivenBack() {
        held();
        assertTrue(scene.station.hold());
        scene.expect(new Retrieve(OWN));
        scene.down(new Setup(THEIRS, Optional.of(THIRD), Optional.empty()));
        scene.expect(new ReleaseComplete(THEIRS.answered(), Optional.of(Cause.USER_BUSY)));
        scene.down(new RetrieveAcknowledge(TO_OWN));
        assertEquals(List.of("retrieved 5550200"), news());
    }

    @Test
    void theOtherPartysHoldIsReported() {
        scene.down(new Facility(TO_OWN, NotifySs.CALL_ON_HOLD.facility()));
        scene.down(new Facility(TO_OWN, NotifySs.CALL_ON_HOLD.facility()));
        scene.down(new Facility(TO_OWN, NotifySs.CALL_RETRIEVED.facility()));
        scene.expectNothing();
        assertEquals(List.of("on hold", "on hold over"), news());
    }

    @Test
    void aHeldCallThatIsOnHoldItselfSaysSoWhenItIsBack() {
        twoCalls();
        scene.down(new Facility(TO_OWN, NotifySs.CALL_ON_HOLD.facility()));
        assertEquals(List.of(), news());
        assertTrue(scene.station.hold());
        scene.down(new HoldAcknowledge(THEIRS));
        scene.down(new RetrieveAcknowledge(TO_OWN));
        assertEquals(List.of("held 5550999", "retrieved 5550200", "on hold"), news());
    }

    @Test
    void aNewCallIsNotOnHoldBecauseAFormerOneWasWhenItEnded() {
        waiting();
        assertTrue(scene.station.rejectWaiting());
        scene.expect(new Disconnect(THEIRS.answered(), Cause.USER_BUSY));
        scene.down(new Facility(THEIRS, NotifySs.CALL_ON_HOLD.facility()));
        scene.down(new ReleaseComplete(THEIRS, Optional.empty()));
        news();
        twoCalls();
        scene.down(new Facility(THEIRS, NotifySs.CALL_ON_HOLD.facility()));
        assertEquals(List.of("on hold"), news());
    }

    @Test
    void anotherFacilityIsNotAnswered() {
        scene.down(new Facility(TO_OWN, OctetString.ofHex("a10302013b")));
        scene.down(new Facility(TO_OWN, OctetString.ofHex("")));
        scene.expectNothing();
        assertEquals(List.of(), news());
        assertFalse(scene.station.answer());
    }
}
