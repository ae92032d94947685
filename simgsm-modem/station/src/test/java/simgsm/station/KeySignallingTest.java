package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl.CallProceeding;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.ConnectAcknowledge;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.CallControl.ReleaseComplete;
import simgsm.air.CallControl.Setup;
import simgsm.air.CallControl.StartDtmf;
import simgsm.air.CallControl.StartDtmfAcknowledge;
import simgsm.air.CallControl.StartDtmfReject;
import simgsm.air.CallControl.StopDtmf;
import simgsm.air.CallControl.StopDtmfAcknowledge;
import simgsm.air.Cause;
import simgsm.air.TransactionIdentifier;
import simgsm.dtmf.DtmfKey;
import simgsm.station.call.MobileCallTable.MobileCallState;

/** Keys as messages: START DTMF, STOP DTMF, and the network's answers (TS 24.008, 5.5.7). */
class KeySignallingTest {
    private final Scene scene = Scene.registered();
    private TransactionIdentifier own;

    private void dial() {
        scene.station.dial(Scene.OTHER);
        scene.acceptService();
        own = scene.expect(Setup.class).transaction();
    }

    private void connect() {
        scene.down(new Connect(own.answered()));
        scene.expect(ConnectAcknowledge.class);
        scene.reported.clear();
    }

    private Scene active() {
        dial();
        connect();
        return scene;
    }

    private void acknowledgeStart(char key) {
        scene.expect(new StartDtmf(own, key));
        scene.down(new StartDtmfAcknowledge(own.answered(), key));
    }

    private void acknowledgeStop() {
        scene.expect(new StopDtmf(own));
        scene.down(new StopDtmfAcknowledge(own.answered()));
    }

    @Test
    void aKeySoundsFromItsAcknowledgementForItsTimeAndHasLeftWhenItsStopIsAcknowledged() {
        active().station.signalKey(DtmfKey.FIVE, 100);
        acknowledgeStart('5');
        scene.pass(100 * Scene.MILLI - 1);
        scene.expectNothing();
        scene.pass(1);
        assertEquals(List.of("sounds 5", "stopping 5"), scene.reported.lines());
        acknowledgeStop();
        assertEquals(List.of("sounds 5", "stopping 5", "completed 5"), scene.reported.lines());
        assertEquals(MobileCallState.ACTIVE, scene.station.snapshot().callState());
    }

    @Test
    void theNextKeyWaitsForTheAcknowledgementAndForThePause() {
        active().station.signalKey(DtmfKey.STAR, 100);
        scene.station.signalKey(DtmfKey.HASH, 100);
        acknowledgeStart('*');
        scene.pass(Scene.SECOND);
        scene.expect(StopDtmf.class);
        scene.pass(Scene.SECOND);
        scene.expectNothing();
        scene.down(new StopDtmfAcknowledge(own.answered()));
        scene.pass(65 * Scene.MILLI);
        scene.expectNothing();
        scene.pass(5 * Scene.MILLI);
        acknowledgeStart('#');
    }

    @Test
    void noToneIsShorterThan70Milliseconds() {
        active().station.signalKey(DtmfKey.ONE, 1);
        acknowledgeStart('1');
        scene.pass(70 * Scene.MILLI - 1);
        scene.expectNothing();
        scene.pass(1);
        acknowledgeStop();
    }

    @Test
    void aHeldKeySoundsUntilItIsLetGo() {
        active().station.holdKey(DtmfKey.NINE);
        acknowledgeStart('9');
        scene.pass(5 * Scene.SECOND);
        scene.expectNothing();
        scene.station.releaseKey();
        acknowledgeStop();
        scene.station.releaseKey();
        scene.expectNothing();
    }

    @Test
    void aHeldKeyThatIsLetGoBeforeTheAnswerSoundsItsLeast() {
        active().station.holdKey(DtmfKey.NINE);
        scene.station.releaseKey();
        acknowledgeStart('9');
        scene.pass(70 * Scene.MILLI - 1);
        scene.expectNothing();
        scene.pass(1);
        acknowledgeStop();
    }

    @Test
    void aSecondHeldKeyLetsTheFirstGo() {
        active().station.holdKey(DtmfKey.ONE);
        acknowledgeStart('1');
        scene.pass(Scene.SECOND);
        scene.station.holdKey(DtmfKey.TWO);
        acknowledgeStop();
        scene.pass(70 * Scene.MILLI);
        acknowledgeStart('2');
    }

    @Test
    void keysWaitForTheCallToBeActive() {
        dial();
        scene.station.signalKey(DtmfKey.ONE, 100);
        scene.down(new CallProceeding(own.answered()));
        scene.expectNothing();
        connect();
        acknowledgeStart('1');
    }

    @Test
    void aRefusedKeyTakesThoseBehindItWithIt() {
        active().station.signalKey(DtmfKey.ONE, 100);
        scene.station.signalKey(DtmfKey.TWO, 100);
        scene.expect(new StartDtmf(own, '1'));
        scene.down(new StartDtmfReject(own.answered(), Cause.SERVICE_NOT_AVAILABLE));
        scene.pass(Scene.SECOND);
        scene.expectNothing();
        assertEquals(List.of("keys refused 63"), scene.reported.lines());
        scene.station.signalKey(DtmfKey.THREE, 100);
        acknowledgeStart('3');
    }

    @Test
    void aNetworkThatDoesNotAnswerIsWaitedForDuringT336AndT337() {
        active().station.signalKey(DtmfKey.ONE, 100);
        scene.expect(StartDtmf.class);
        keepAlive(10 * Scene.SECOND - 1);
        assertEquals(List.of(), scene.reported.lines());
        scene.pass(1);
        assertEquals(List.of("keys refused 102"), scene.reported.lines());
        scene.reported.clear();

        scene.station.signalKey(DtmfKey.TWO, 100);
        acknowledgeStart('2');
        scene.pass(100 * Scene.MILLI);
        scene.expect(StopDtmf.class);
        keepAlive(10 * Scene.SECOND);
        assertEquals(List.of("sounds 2", "stopping 2", "keys refused 102"), scene.reported.lines());
    }

    /** The far end goes on speaking, so that the call does not die. */
    private void keepAlive(long nanos) {
        byte[] silence = new byte[160];
        for (long left = nanos; left > 0; left -= Scene.SECOND) {
            scene.pass(Math.min(left, Scene.SECOND));
            scene.frame(IpaFrame.SPEECH, new RtpPacket(RtpPacket.A_LAW, 0, 0, left / Scene.MILLI, silence).encode());
        }
    }

    @Test
    void theEndOfTheCallForgetsAllKeys() {
        active().station.signalKey(DtmfKey.ONE, 100);
        scene.station.signalKey(DtmfKey.TWO, 100);
        scene.expect(StartDtmf.class);
        scene.station.hangUp();
        scene.expect(Disconnect.class);
        scene.down(new StartDtmfAcknowledge(own.answered(), '1'));
        scene.pass(Scene.SECOND);
        scene.expectNothing();
        scene.down(new ReleaseComplete(own.answered(), Optional.empty()));
        scene.releaseChannel();
        assertEquals(List.of("released 16"), scene.reported.lines());
        active();
        scene.pass(Scene.SECOND);
        scene.expectNothing();
    }

    @Test
    void unexpectedAcknowledgementsAreIgnored() {
        active();
        scene.down(new StopDtmfAcknowledge(own.answered()));
        scene.down(new StartDtmfAcknowledge(own.answered(), '1'));
        scene.down(new StartDtmfReject(own.answered(), Cause.SERVICE_NOT_AVAILABLE));
        scene.expectNothing();
        assertTrue(scene.reported.lines().isEmpty());
    }
}
