package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.center.msc.ActiveCall.CALLED_TRANSACTION;
import static simgsm.center.msc.TestMobile.OUR_CALL;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.center.msc.link.NetworkTimer;

/** Calls to a subscriber whose older call is being cleared. */
class RedialTest {
    private final TestNetwork network = new TestNetwork();

    /** The caller has hung up and dials again at once; the called side still owes the answer to DISCONNECT. */
    private ActiveCall hungUpAndDialledAgain() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().hangUp(OUR_CALL);
        call.caller().leaveReleasedChannel();
        call.called().next(CallControl.Disconnect.class);
        call.caller().dial("5550200");
        call.caller().next(CallControl.CallProceeding.class);
        assertTrue(call.caller().hasNothing(), "no busy for a call that is being cleared");
        assertTrue(call.called().hasNothing(), "nothing is offered before the old call is gone");
        return call;
    }

    @Test
    void aCallToASubscriberWhoseOldCallIsBeingClearedWaitsForItsEnd() {
        TestMobile called = hungUpAndDialledAgain().called();
        called.tell(new CallControl.Release(CALLED_TRANSACTION, Optional.empty()));
        called.next(CallControl.ReleaseComplete.class);
        assertEquals(
                TestNetwork.number("5550100"),
                called.next(CallControl.Setup.class).calling());
        assertTrue(called.hasNothing());
    }

    @Test
    void aMobileThatDoesNotFinishClearingInTimeIsBusy() {
        ActiveCall call = hungUpAndDialledAgain();
        network.pass(Duration.ofNanos(NetworkTimer.HELD_CALL.nanos() - 1));
        assertTrue(call.caller().hasNothing());
        network.pass(Duration.ofNanos(1));
        assertEquals(
                Cause.USER_BUSY,
                call.caller().next(CallControl.Disconnect.class).cause());
    }

    @Test
    void whoIsHeldMayHangUp() {
        ActiveCall call = hungUpAndDialledAgain();
        call.caller().hangUp(OUR_CALL);
        call.called().tell(new CallControl.Release(CALLED_TRANSACTION, Optional.empty()));
        call.called().next(CallControl.ReleaseComplete.class);
        call.called().leaveReleasedChannel();
        assertTrue(call.called().hasNothing());
        assertTrue(network.exchange.calls().isEmpty());
    }

    @Test
    void aHeldCallWhoseMobileGoesAwayIsRefusedAsOutOfOrder() {
        ActiveCall call = hungUpAndDialledAgain();
        call.called().vanish();
        assertEquals(
                Cause.DESTINATION_OUT_OF_ORDER,
                call.caller().next(CallControl.Disconnect.class).cause());
    }

    @Test
    void ofTwoHeldCallsTheOlderGetsThroughAndTheOtherIsRefusedAsBusy() {
        ActiveCall call = hungUpAndDialledAgain();
        TestMobile third = network.attach("5550101");
        third.dial("5550200");
        third.next(CallControl.CallProceeding.class);
        assertTrue(third.hasNothing());
        call.called().tell(new CallControl.Release(CALLED_TRANSACTION, Optional.empty()));
        call.called().next(CallControl.ReleaseComplete.class);
        assertEquals(
                TestNetwork.number("5550100"),
                call.called().next(CallControl.Setup.class).calling());
        assertEquals(Cause.USER_BUSY, third.next(CallControl.Disconnect.class).cause());
    }

    @Test
    void aCallerWhoseOwnOldCallIsBeingClearedCanBeCalledAfterIt() {
        ActiveCall call = network.activeCall("5550100", "5550200");
        call.caller().tell(new CallControl.Disconnect(OUR_CALL, Cause.NORMAL_CALL_CLEARING));
        call.caller().next(CallControl.Release.class);
        TestMobile third = network.attach("5550101");
        third.dial("5550100");
        third.next(CallControl.CallProceeding.class);
        assertTrue(third.hasNothing() && call.caller().hasNothing());
        call.caller().tell(new CallControl.ReleaseComplete(OUR_CALL, Optional.empty()));
        call.caller().next(CallControl.Setup.class);
    }
}
