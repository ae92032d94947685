package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl.Alerting;
import simgsm.air.CallControl.CallProceeding;
import simgsm.air.CallControl.Connect;
import simgsm.air.CallControl.ConnectAcknowledge;
import simgsm.air.CallControl.Disconnect;
import simgsm.air.CallControl.Progress;
import simgsm.air.CallControl.Release;
import simgsm.air.CallControl.ReleaseComplete;
import simgsm.air.CallControl.Setup;
import simgsm.air.Cause;
import simgsm.air.CauseLocation;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.station.call.MobileCallTable.MobileCallState;

/** A network that lets its own tones be heard (TS 24.008, 5.5.1 and 5.4.4.1.1.1). */
class NetworkTonesTest {
    private static final TransactionIdentifier OWN = new TransactionIdentifier(0, false);
    private static final TransactionIdentifier TO_OWN = OWN.answered();

    private int sequence;

    private static Scene proceeding() {
        Scene scene = Scene.registered();
        scene.station.dial(Scene.OTHER);
        scene.acceptService();
        scene.expect(Setup.class);
        scene.down(new CallProceeding(TO_OWN));
        scene.reported.clear();
        return scene;
    }

    private void play(Scene scene) {
        RtpPacket packet = new RtpPacket(RtpPacket.A_LAW, sequence, 160L * sequence++, 7, new byte[160]);
        scene.frame(IpaFrame.SPEECH, packet.encode());
    }

    private static MobileCallState stateOf(Scene scene) {
        return scene.station.snapshot().callState();
    }

    @Test
    void ringBackIsHeardBeforeTheCallIsConnected() {
        Scene scene = proceeding();
        scene.down(new Alerting(TO_OWN, true));
        assertEquals(List.of("network tones", "alerting"), scene.reported.lines());
        play(scene);
        play(scene);
        assertEquals(2, scene.reported.heard.size());
        scene.down(new Connect(TO_OWN));
        scene.expect(new ConnectAcknowledge(OWN));
        assertEquals(List.of("network tones", "alerting", "connected 5550200", "own tones"), scene.reported.lines());
        play(scene);
        assertEquals(3, scene.reported.heard.size());
    }

    @Test
    void withoutTheIndicatorNothingIsHeardBeforeTheCallIsConnected() {
        Scene scene = proceeding();
        scene.down(new Alerting(TO_OWN));
        play(scene);
        assertEquals(List.of("alerting"), scene.reported.lines());
        assertTrue(scene.reported.heard.isEmpty());
    }

    @Test
    void anAnnouncementIsHeardAndItsSilenceIsNoReasonToClear() {
        Scene scene = proceeding();
        scene.down(new Progress(TO_OWN));
        play(scene);
        assertEquals(1, scene.reported.heard.size());
        scene.pass(60 * Scene.SECOND);
        assertEquals(MobileCallState.MO_CALL_PROCEEDING, stateOf(scene));
    }

    @Test
    void aBusyToneIsHeardUntilTheUserHasHeardEnough() {
        Scene scene = proceeding();
        scene.down(new Disconnect(TO_OWN, Cause.USER_BUSY, CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER, true));
        assertEquals(MobileCallState.DISCONNECT_INDICATION, stateOf(scene));
        scene.expectNothing();
        play(scene);
        assertEquals(1, scene.reported.heard.size());
        assertTrue(scene.station.hangUp());
        scene.expect(new Release(OWN, Optional.empty()));
        play(scene);
        assertEquals(1, scene.reported.heard.size());
        scene.down(new ReleaseComplete(TO_OWN, Optional.empty()));
        assertEquals(MobileCallState.NULL, stateOf(scene));
        assertEquals(List.of("released 17", "network tones", "own tones"), scene.reported.lines());
        assertFalse(scene.station.hangUp());
    }

    @Test
    void theNetworkMayEndItsTone() {
        Scene scene = proceeding();
        scene.down(new Disconnect(TO_OWN, Cause.USER_BUSY, CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER, true));
        scene.down(new Release(TO_OWN, Optional.of(Cause.USER_BUSY)));
        scene.expect(new ReleaseComplete(OWN, Optional.empty()));
        assertEquals(MobileCallState.NULL, stateOf(scene));
        assertEquals(List.of("released 17", "network tones", "own tones"), scene.reported.lines());
    }

    @Test
    void aToneThatNeverComesIsNotWaitedFor() {
        Scene scene = proceeding();
        scene.down(new Disconnect(TO_OWN, Cause.USER_BUSY, CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER, true));
        scene.pass(11 * Scene.SECOND);
        scene.expect(new Release(OWN, Optional.empty()));
        assertEquals(List.of("released 17", "network tones", "own tones"), scene.reported.lines());
    }

    @Test
    void whoDialsAgainHearsNoMoreOfTheLastCall() {
        Scene scene = proceeding();
        scene.down(new Disconnect(TO_OWN, Cause.USER_BUSY, CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER, true));
        assertTrue(scene.station.dial(new Msisdn("5550300")));
        scene.expect(new Release(OWN, Optional.empty()));
        scene.down(new ReleaseComplete(TO_OWN, Optional.empty()));
        assertEquals(List.of("released 17", "network tones", "own tones", "calling 5550300"), scene.reported.lines());
    }

    @Test
    void powerOffEndsTheTone() {
        Scene scene = proceeding();
        scene.down(new Disconnect(TO_OWN, Cause.USER_BUSY, CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER, true));
        scene.station.powerOff();
        assertEquals(
                List.of("released 17", "network tones", "own tones"),
                scene.reported.lines().subList(0, 3));
        assertEquals(MobileCallState.NULL, stateOf(scene));
    }
}
