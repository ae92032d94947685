package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.RadioResource;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.msc.link.Link;

/** Silent peers, babbling peers, and peers that never leave. */
class SupervisionTest {
    private final TestNetwork network = new TestNetwork();

    @Test
    void aPeerThatAnswersItsPingsIsKept() {
        TestMobile mobile = network.attach("5550100");
        mobile.answersPings = false;
        for (int i = 0; i < 10; i++) {
            network.passSeconds(30);
            mobile.next(CcmMessage.Ping.class);
            mobile.ccm(new CcmMessage.Pong());
        }
        assertEquals(Optional.empty(), mobile.closedFor);
    }

    @Test
    void aSilentPeerIsDroppedAfterThreeUnansweredPings() {
        TestMobile mobile = network.attach("5550100");
        mobile.answersPings = false;
        for (int i = 0; i < 3; i++) {
            network.passSeconds(30);
            mobile.next(CcmMessage.Ping.class);
        }
        assertEquals(Optional.empty(), mobile.closedFor);
        network.passSeconds(30);
        assertTrue(mobile.closedFor.isPresent());
        assertEquals(new ExchangeEvent.Detached(new Msisdn("5550100")), network.events.get(1));
        assertEquals(0, network.exchange.linkCount());
    }

    @Test
    void aPeersPingIsAnswered() {
        TestMobile mobile = network.attach("5550100");
        mobile.ccm(new CcmMessage.Ping());
        mobile.next(CcmMessage.Pong.class);
    }

    @Test
    void noTimerIsLeftBehindByALinkThatHasGone() {
        TestMobile mobile = network.attach("5550100");
        mobile.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
        mobile.vanish();
        assertTrue(network.exchange.nextDeadlineNanos().isEmpty());
    }

    @Test
    void aPeerThatBabblesIsAnsweredAndAtLastDropped() {
        TestMobile mobile = network.attach("5550100");
        for (int i = 0; i < Link.MAX_VIOLATIONS - 1; i++) {
            mobile.frame(new IpaFrame(0x42, new byte[] {1, 2, 3}));
        }
        assertEquals(Optional.empty(), mobile.closedFor);
        mobile.frame(new IpaFrame(0x42, new byte[0]));
        assertTrue(mobile.closedFor.isPresent());
        mobile.frame(new IpaFrame(0x42, new byte[0]));
    }

    @Test
    void brokenFramesOfEveryStreamAreSurvived() {
        TestMobile mobile = network.attach("5550100");
        for (int stream : new int[] {IpaFrame.RSL, IpaFrame.CCM, IpaFrame.SPEECH}) {
            for (int length = 0; length < 12; length++) {
                mobile.frame(new IpaFrame(stream, new byte[length]));
            }
        }
        assertEquals(Optional.empty(), mobile.closedFor);
        mobile.register();
    }

    @Test
    void layer3WithoutARadioConnectionIsNotHeard() {
        TestMobile mobile = network.attach("5550100");
        mobile.tell(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.SHORT_MESSAGE, MobilityManagement.NO_KEY, mobile.identity()));
        assertTrue(mobile.hasNothing());
    }

    @Test
    void aMessageOfUnknownTypeGetsStatus97() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().tellOctets("037f");
        CallControl.Status status = call.caller().next(CallControl.Status.class);
        assertEquals(Cause.MESSAGE_TYPE_NON_EXISTENT, status.cause());
        assertEquals(10, status.callState());
    }

    @Test
    void aMessageThatDoesNotFitTheStateGetsStatus98AndTheCallGoesOn() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().tell(new CallControl.Alerting(TestMobile.OUR_CALL));
        CallControl.Status status = call.caller().next(CallControl.Status.class);
        assertEquals(Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE, status.cause());
        assertEquals(CallProgress.ACTIVE, network.exchange.calls().get(0).state());
    }

    @Test
    void whatStillComesUpAfterChannelReleaseIsIgnoredUntilTheNextConnection() {
        TestMobile mobile = network.attach("5550100");
        mobile.dial("5550999");
        mobile.next(CallControl.ReleaseComplete.class);
        mobile.next(RadioResource.ChannelRelease.class);
        mobile.tell(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.SHORT_MESSAGE, MobilityManagement.NO_KEY, mobile.identity()));
        assertTrue(mobile.hasNothing());
        mobile.requestService(MobilityManagement.ServiceType.SHORT_MESSAGE);
    }

    @Test
    void aMobileThatNeverLeavesItsChannelCanBePagedAfter5Seconds() {
        TestMobile caller = network.attach("5550100");
        TestMobile called = network.attach("5550200");
        called.dial("5550999");
        called.next(CallControl.ReleaseComplete.class);
        called.next(RadioResource.ChannelRelease.class);
        caller.dial("5550200");
        assertTrue(called.hasNothing());
        network.passSeconds(5);
        called.next(RslMessage.PagingCommand.class);
    }

    @Test
    void whatOnlyTheNetworkSendsIsABreach() {
        TestMobile mobile = network.attach("5550100");
        mobile.rsl(new RslMessage.PagingCommand(mobile.imsi));
        mobile.rsl(new RslMessage.ErrorIndication(RslMessage.Sapi.SIGNALLING, 1));
        assertTrue(mobile.hasNothing());
        assertEquals(List.of(new ExchangeEvent.Attached(new Msisdn("5550100"))), network.events);
    }
}
