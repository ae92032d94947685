package simgsm.modem;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.air.CallControl.Alerting;
import simgsm.air.CallControl.CallConfirmed;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.Cause;
import simgsm.dtmf.DtmfKey;

class ModemTest {
    private final CalledModem scene = new CalledModem();

    private CalledModem denying() {
        scene.pass(500);
        scene.callerHangsUp();
        scene.told.clear();
        scene.heardByCaller.setLength(0);
        scene.heardDigits.clear();
        scene.decision = new CallDecision(false, DtmfKey.TWO);
        scene.call();
        return scene;
    }

    @Test
    void aCallIsAlertedAndConnectedAtOnceAndAnsweredWithItsTone() {
        List<Class<?>> kinds =
                scene.sent.stream().<Class<?>>map(Object::getClass).toList();
        assertEquals(List.of(CallConfirmed.class, Alerting.class, Connect.class), kinds.subList(2, 5));
        assertEquals(List.of("ringing 5550100", "call 5550100", "connected 5550100"), scene.told);
        scene.pass(500);
        assertEquals("1", scene.heardByCaller.toString());
        assertEquals(List.of("ringing 5550100", "call 5550100", "connected 5550100", "tone 1"), scene.told);
    }

    @Test
    void aModemRingsForItsTimeAndThenAsksWhetherToAcceptAndConnects() {
        CalledModem ringing = new CalledModem(1500);
        ringing.pass(1480);
        assertEquals(List.of("ringing 5550100"), ringing.told);
        assertTrue(ringing.sent.stream().anyMatch(Alerting.class::isInstance));
        assertFalse(ringing.sent.stream().anyMatch(Connect.class::isInstance));
        ringing.pass(40);
        assertEquals(List.of("ringing 5550100", "call 5550100", "connected 5550100"), ringing.told);
        ringing.pass(500);
        assertEquals("1", ringing.heardByCaller.toString());
    }

    @Test
    void aHangUpWhileItRingsReleasesTheCallAndTheNextRingsItsWholeTime() {
        CalledModem ringing = new CalledModem(1500);
        ringing.pass(1000);
        ringing.callerHangsUp();
        assertEquals(List.of("ringing 5550100", "ended 16"), ringing.told);
        ringing.told.clear();
        ringing.call();
        ringing.pass(1480);
        assertEquals(List.of("ringing 5550100"), ringing.told);
        ringing.pass(40);
        assertEquals(List.of("ringing 5550100", "call 5550100", "connected 5550100"), ringing.told);
    }

    @Test
    void aRingingModemCanAnswerEarlyOrHangUp() {
        CalledModem answering = new CalledModem(1500);
        answering.pass(200);
        assertTrue(answering.modem.answer());
        assertFalse(answering.modem.answer());
        answering.pass(3000);
        assertEquals(List.of("ringing 5550100", "call 5550100", "connected 5550100", "tone 1"), answering.told);
        CalledModem refusing = new CalledModem(1500);
        assertTrue(refusing.modem.hangUp());
        refusing.pass(3000);
        assertEquals(List.of("ringing 5550100", "ended 16"), refusing.told);
    }

    @Test
    void aLostLinkEndsTheRinging() {
        CalledModem ringing = new CalledModem(1500);
        ringing.lose();
        assertEquals(List.of("ringing 5550100", "ended 41"), ringing.told);
        assertFalse(ringing.modem.answer());
    }

    @Test
    void keysAreHeardWhileTonesAreSent() {
        scene.press("**#**20**");
        scene.pass(2000);
        assertEquals(
                List.of("key *", "key *", "key #", "key *", "key *", "key 2", "key 0", "key *", "key *"),
                scene.told.stream().filter(line -> line.startsWith("key")).toList());
        assertEquals(2000 * 8, scene.speechTimeSamples);
    }

    @Test
    void repliesQueueWith150MillisecondsAnd70Between() {
        scene.pass(1000);
        scene.modem.sendTone(DtmfKey.SIX);
        scene.modem.sendTone(DtmfKey.THREE);
        scene.pass(1000);
        assertEquals("163", scene.heardByCaller.toString());
        long apart = scene.heardDigits.get(2).startedAtSample()
                - scene.heardDigits.get(1).startedAtSample();
        assertEquals(220 * 8, apart, 40);
        assertEquals(List.of("tone 1", "tone 6", "tone 3"), scene.told.subList(3, 6));
    }

    @Test
    void aDeniedCallHearsItsToneAndIsThenCleared() {
        denying().press("**#**20**");
        scene.pass(140);
        assertFalse(scene.sent.stream().anyMatch(Disconnect.class::isInstance));
        scene.pass(2000);
        assertEquals("2", scene.heardByCaller.toString());
        assertEquals(List.of("ringing 5550100", "call 5550100", "tone 2", "ended 16"), scene.told);
        Disconnect end = (Disconnect) scene.sent.get(scene.sent.size() - 2);
        assertEquals(Cause.NORMAL_CALL_CLEARING, end.cause());
        assertTrue(scene.heardDigits.get(0).startedAtSample() < 40, "the tone is the first thing heard");
    }

    @Test
    void aDeniedCallerGetsNoOtherTone() {
        denying();
        scene.modem.sendTone(DtmfKey.THREE);
        scene.pass(1000);
        assertEquals("2", scene.heardByCaller.toString());
    }

    @Test
    void aMinuteWithoutAKeyEndsTheCallAndTheReasonIsReported() {
        scene.pass(160);
        scene.pass(59_980);
        assertFalse(scene.told.contains("ended 16"));
        assertFalse(scene.told.contains("idle 60"));
        scene.pass(60);
        assertEquals(List.of("idle 60", "ended 16"), scene.told.subList(scene.told.size() - 2, scene.told.size()));
        Disconnect end = (Disconnect) scene.sent.get(scene.sent.size() - 2);
        assertEquals(Cause.NORMAL_CALL_CLEARING, end.cause());
    }

    @Test
    void aKeyStartsTheMinuteAgain() {
        scene.pass(50_000);
        scene.press("5");
        scene.pass(59_000);
        assertFalse(scene.told.contains("ended 16"));
        scene.pass(2_000);
        assertTrue(scene.told.contains("ended 16"));
    }

    @Test
    void anOrderUnderWayStopsTheMinuteAndItsReplyStartsItAgain() {
        scene.pass(50_000);
        scene.modem.setOrderUnderWay(true);
        scene.pass(300_000);
        assertFalse(scene.told.contains("ended 16"));
        scene.modem.sendTone(DtmfKey.THREE);
        scene.modem.setOrderUnderWay(false);
        scene.pass(59_000);
        assertFalse(scene.told.contains("ended 16"));
        scene.pass(2_000);
        assertTrue(scene.told.contains("ended 16"));
    }

    @Test
    void twoSecondsWithoutASpeechFrameEndTheCallWithCause41() {
        scene.pass(1000);
        scene.callerSpeaks = false;
        scene.pass(1980);
        assertFalse(scene.told.contains("ended 41"));
        scene.pass(60);
        assertTrue(scene.told.contains("ended 41"));
        Disconnect end = (Disconnect) scene.sent.get(scene.sent.size() - 2);
        assertEquals(Cause.TEMPORARY_FAILURE, end.cause());
    }

    @Test
    void aCallWithoutSpeechIsKept() {
        scene.pass(30_000);
        assertFalse(scene.told.contains("ended 41"));
    }

    @Test
    void theCallersHangUpEndsTheCallAndDropsTonesThatWait() {
        scene.pass(1000);
        scene.modem.sendTone(DtmfKey.SIX);
        scene.modem.sendTone(DtmfKey.FOUR);
        scene.callerHangsUp();
        assertEquals("ended 16", scene.told.get(scene.told.size() - 1));
        assertFalse(scene.told.contains("idle 60"));
        scene.modem.sendTone(DtmfKey.THREE);
        scene.call();
        scene.pass(1000);
        assertEquals("11", scene.heardByCaller.toString());
    }

    @Test
    void theModemHangsUpWithCause16() {
        scene.pass(100);
        assertTrue(scene.modem.hangUp());
        assertFalse(scene.modem.hangUp());
        assertEquals("ended 16", scene.told.get(scene.told.size() - 1));
    }

    @Test
    void eachCallHasItsOwnMinuteAndItsOwnEnd() {
        scene.pass(50_000);
        scene.callerHangsUp();
        scene.call();
        scene.pass(50_000);
        assertEquals(1, scene.told.stream().filter("ended 16"::equals).count());
        assertEquals(2, scene.told.stream().filter("connected 5550100"::equals).count());
    }
}
