package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.msc.ActiveCall.CALLED_TRANSACTION;
import static simgsm.center.msc.TestMobile.OUR_CALL;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.CauseLocation;
import simgsm.air.ProtocolViolation;
import simgsm.center.subscriber.HomeRegister;
import simgsm.dtmf.Goertzel;
import simgsm.speech.SpeechCodec;
import simgsm.tone.ToneLevel;
import simgsm.tone.ToneSet;

/** The centre with {@code --tones}: callers hear ring-back and failure in-band (TS 24.008, 5.5.1 and 5.4.4.1.1). */
class NetworkTonesTest {
    private final TestNetwork network = new TestNetwork(HomeRegister.OPEN, Optional.of(ToneSet.EUROPEAN));

    private static double dbm0(TestMobile mobile, double hertz, int fromFrame, int toFrame) {
        Goertzel filter = new Goertzel(hertz);
        SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
        for (int i = fromFrame; i < toFrame; i++) {
            try {
                RtpPacket packet = RtpPacket.decode(mobile.heard.get(i));
                assertEquals(i, packet.sequence());
                filter.accept(codec.decode(packet.payload()), 0, SpeechCodec.SAMPLES_PER_FRAME);
            } catch (ProtocolViolation violation) {
                throw new AssertionError(violation);
            }
        }
        return ToneLevel.dbm0(Math.max(1, filter.amplitude()));
    }

    private TestMobile callerOfARingingPhone() {
        TestMobile caller = network.attach("5550100");
        TestMobile called = network.attach("5550200");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
        called.ring();
        assertTrue(caller.next(CallControl.Alerting.class).inBand());
        network.pass(Duration.ofMillis(5900));
        called.tell(new CallControl.Connect(CALLED_TRANSACTION));
        caller.next(CallControl.Connect.class);
        return caller;
    }

    @Test
    void aCallerHearsRingBackUntilTheCallIsAnswered() {
        TestMobile caller = callerOfARingingPhone();
        int frames = caller.heard.size();
        assertEquals(5900 / 20 + 1, frames);
        assertEquals(-13, dbm0(caller, 425, 1, 49), 0.3);
        assertTrue(dbm0(caller, 425, 50, 250) < -60);
        assertEquals(-13, dbm0(caller, 425, 251, 290), 0.3);
        network.pass(Duration.ofSeconds(2));
        assertEquals(frames, caller.heard.size());
    }

    @Test
    void aBusyPhoneIsHeardAsBusyUntilTheCallerReleases() {
        network.activeCall("5550200", "5550300");
        TestMobile caller = network.attach("5550100");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
        CallControl.Disconnect disconnect = caller.next(CallControl.Disconnect.class);
        assertEquals(
                new CallControl.Disconnect(
                        OUR_CALL.answered(), Cause.USER_BUSY, CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER, true),
                disconnect);
        network.pass(Duration.ofMillis(1990));
        assertEquals(100, caller.heard.size());
        assertEquals(-13, dbm0(caller, 425, 1, 24), 0.3);
        assertTrue(dbm0(caller, 425, 25, 50) < -60);
        assertEquals(-13, dbm0(caller, 425, 51, 74), 0.3);
        caller.tell(new CallControl.Release(OUR_CALL, Optional.empty()));
        caller.next(CallControl.ReleaseComplete.class);
        network.pass(Duration.ofSeconds(1));
        assertEquals(100, caller.heard.size());
        caller.leaveReleasedChannel();
    }

    @Test
    void theNetworkReleasesAListeningCallerAfterThirtySeconds() {
        TestMobile caller = network.attach("5550100");
        caller.dial("5550999");
        caller.next(CallControl.CallProceeding.class);
        assertTrue(caller.next(CallControl.Disconnect.class).inBand());
        network.pass(Duration.ofMillis(29_900));
        caller.answerPings();
        assertTrue(caller.hasNothing());
        network.pass(Duration.ofMillis(200));
        assertEquals(
                Optional.of(Cause.UNASSIGNED_NUMBER),
                caller.next(CallControl.Release.class).cause());
        int frames = caller.heard.size();
        network.pass(Duration.ofSeconds(1));
        assertEquals(frames, caller.heard.size());
        assertEquals(-13, dbm0(caller, 950, 1, 16), 0.5);
        assertEquals(-13, dbm0(caller, 1400, 17, 33), 0.5);
        assertEquals(-13, dbm0(caller, 1800, 34, 49), 0.5);
    }

    @Test
    void aCallThatWasSpokenInEndsWithoutATone() {
        TestMobile caller = callerOfARingingPhone();
        caller.tell(new CallControl.ConnectAcknowledge(OUR_CALL));
        int frames = caller.heard.size();
        network.exchange.linkClosed(network.nowNanos, network.mobile("5550200").link, "gone");
        CallControl.Disconnect disconnect = caller.next(CallControl.Disconnect.class);
        assertFalse(disconnect.inBand());
        network.pass(Duration.ofSeconds(1));
        assertEquals(frames, caller.heard.size());
    }

    @Test
    void aRejectedCallHasNoToneOfItsOwn() {
        TestMobile caller = network.attach("5550100");
        TestMobile called = network.attach("5550200");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
        called.ring();
        caller.next(CallControl.Alerting.class);
        called.tell(new CallControl.Disconnect(CALLED_TRANSACTION, Cause.CALL_REJECTED));
        assertFalse(caller.next(CallControl.Disconnect.class).inBand());
    }

    @Test
    void noToneIsPlayedToAVanishedCaller() {
        TestMobile caller = network.attach("5550100");
        caller.dial("5550999");
        caller.vanish();
        int frames = caller.heard.size();
        network.pass(Duration.ofSeconds(1));
        assertEquals(frames, caller.heard.size());
    }

    @Test
    void aNetworkOfUsualKindLeavesTonesToThePhones() {
        TestNetwork usual = new TestNetwork();
        TestMobile caller = usual.attach("5550100");
        TestMobile called = usual.attach("5550200");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
        called.ring();
        assertFalse(caller.next(CallControl.Alerting.class).inBand());
        called.tell(new CallControl.Disconnect(CALLED_TRANSACTION, Cause.USER_BUSY));
        assertFalse(caller.next(CallControl.Disconnect.class).inBand());
        usual.pass(Duration.ofSeconds(5));
        assertTrue(caller.heard.isEmpty());
    }
}
