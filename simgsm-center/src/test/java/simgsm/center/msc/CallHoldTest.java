package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;

/** Calls that are held and retrieved, on both sides of the air (TS 24.083, 2). */
class CallHoldTest extends ThreePhones {
    CallHoldTest() {
        super(true);
    }

    private void hold(Phone phone) {
        assertTrue(phone.station.hold());
        settle();
    }

    @Test
    void aCallIsHeldForAMinuteAndRetrieved() {
        aliceTalksWithBob();
        hold(bob);
        assertEquals(List.of("held 5550100"), bob.news());
        seconds(60);
        assertEquals(List.of(), alice.news());
        hold(bob);
        assertEquals(List.of("retrieved 5550100"), bob.news());
        bob.station.hangUp();
        settle();
        assertEquals(List.of("released 16"), alice.news());
        assertTrue(exchange.calls().isEmpty());
    }

    @Test
    void aHeldMobileIsNotifiedUntilTheCallIsTakenBack() {
        aliceTalksWithBob();
        hold(bob);
        assertTrue(alice.isOnHold);
        assertFalse(bob.isOnHold);
        hold(bob);
        assertFalse(alice.isOnHold);
    }

    @Test
    void aMobileThatHoldsTooIsNotifiedOfTheOthersHoldWhenTheCallIsTakenBack() {
        aliceTalksWithBob();
        hold(bob);
        hold(alice);
        hold(bob);
        assertTrue(bob.isOnHold);
        hold(alice);
        assertFalse(alice.isOnHold);
        assertFalse(bob.isOnHold);
    }

    @Test
    void whoIsHeldHearsTheNetworksToneAndNothingOfTheOther() {
        aliceTalksWithBob();
        bob.level = 4000;
        assertTrue(alice.hears());
        hold(bob);
        seconds(1);
        assertFalse(bob.hears());
        alice.heardSound = false;
        int before = alice.heardFrames;
        seconds(5);
        assertTrue(alice.heardSound, "the tone");
        assertTrue(alice.heardFrames - before > 200, "frames go on");
        bob.level = 0;
        hold(bob);
        alice.level = 4000;
        assertTrue(bob.hears());
        assertFalse(alice.hears(), "no tone any more");
    }

    @Test
    void aWaitingCallIsAnsweredWhileTheFirstIsHeld() {
        aliceTalksWithBob();
        carol.dial(BOB);
        assertEquals(List.of("waiting 5550102"), bob.news());
        hold(bob);
        assertEquals(List.of("held 5550100", "connected 5550102"), bob.news());
        assertEquals(List.of("alerting", "connected 5550101"), carol.news());
        bob.level = 4000;
        assertTrue(carol.hears());
    }

    private void bobTalksWithCarolAndHoldsAlice() {
        aliceTalksWithBob();
        carol.dial(BOB);
        hold(bob);
        bob.news();
        carol.news();
    }

    @Test
    void twoCallsChangePlaces() {
        bobTalksWithCarolAndHoldsAlice();
        for (int i = 0; i < 3; i++) {
            hold(bob);
            assertEquals(List.of("held 5550102", "retrieved 5550100"), bob.news());
            hold(bob);
            assertEquals(List.of("held 5550100", "retrieved 5550102"), bob.news());
        }
        assertEquals(2, exchange.calls().size());
        bob.level = 4000;
        seconds(1);
        assertTrue(carol.hears());
    }

    @Test
    void whenTheActiveCallEndsTheHeldOneStaysAndIsRetrieved() {
        bobTalksWithCarolAndHoldsAlice();
        carol.station.hangUp();
        settle();
        assertEquals(List.of("released 16"), bob.news());
        seconds(30);
        assertEquals(List.of(), alice.news());
        hold(bob);
        assertEquals(List.of("retrieved 5550100"), bob.news());
    }

    @Test
    void whileTheHeldCallIsGivenBackNoNumberIsDialled() {
        aliceTalksWithBob();
        hold(bob);
        bob.news();
        assertTrue(bob.station.hold());
        assertFalse(bob.station.dial(new Msisdn(CAROL)));
        settle();
        assertEquals(List.of("retrieved 5550100"), bob.news());
        assertEquals(List.of(), carol.news());
        bob.level = 4000;
        seconds(1);
        assertTrue(alice.hears());
    }

    @Test
    void theHeldCallFollowsTheOneThatIsEndedIfItIsAskedFor() {
        bobTalksWithCarolAndHoldsAlice();
        bob.station.hangUp();
        bob.station.hold();
        settle();
        assertEquals(List.of("released 16", "retrieved 5550100"), bob.news());
        assertEquals(List.of("released 16"), carol.news());
    }

    @Test
    void whoIsHeldMayHangUp() {
        bobTalksWithCarolAndHoldsAlice();
        alice.station.hangUp();
        settle();
        assertEquals(List.of("held over 16"), bob.news());
        assertEquals(1, exchange.calls().size());
        bob.level = 4000;
        assertTrue(carol.hears());
    }

    @Test
    void theHeldCallIsEndedAlone() {
        bobTalksWithCarolAndHoldsAlice();
        assertTrue(bob.station.rejectWaiting());
        settle();
        assertEquals(List.of("held over 16"), bob.news());
        assertEquals(List.of("released 16"), alice.news());
        assertEquals(1, exchange.calls().size());
    }

    @Test
    void theRedKeyEndsACallThatIsHeldAlone() {
        aliceTalksWithBob();
        hold(bob);
        assertTrue(bob.station.hangUp());
        settle();
        assertEquals(List.of("held 5550100", "held over 16"), bob.news());
        assertEquals(List.of("released 16"), alice.news());
        seconds(30);
        assertTrue(exchange.calls().isEmpty());
        bob.dial(ALICE);
        assertEquals(List.of("ringing 5550101"), alice.news());
    }

    @Test
    void aSecondNumberIsDialledWhileTheFirstCallIsHeld() {
        aliceTalksWithBob();
        hold(alice);
        alice.dial(CAROL);
        carol.station.answer();
        settle();
        assertEquals(List.of("held 5550101", "alerting", "connected 5550102"), alice.news());
        hold(alice);
        assertEquals(List.of("held 5550102", "retrieved 5550101"), alice.news());
        alice.station.hangUp();
        settle();
        assertEquals(List.of("released 16"), alice.news());
        seconds(30);
        assertEquals(1, exchange.calls().size());
        hold(alice);
        assertEquals(List.of("retrieved 5550102"), alice.news());
    }

    @Test
    void aSecondNumberThatIsBusyLeavesTheHeldCall() {
        aliceTalksWithBob();
        hold(alice);
        alice.dial("5559999");
        assertEquals(List.of("held 5550101", "released 1"), alice.news());
        seconds(30);
        hold(alice);
        assertEquals(List.of("retrieved 5550101"), alice.news());
    }

    @Test
    void aDialledNumberIsWithdrawnBeforeTheNetworkHasAnswered() {
        aliceTalksWithBob();
        hold(alice);
        alice.station.dial(new Msisdn(CAROL));
        alice.station.hangUp();
        settle();
        assertEquals(List.of("held 5550101", "released 16"), alice.news());
        seconds(30);
        hold(alice);
        assertEquals(List.of("retrieved 5550101"), alice.news());
    }

    @Test
    void bothMayHold() {
        aliceTalksWithBob();
        hold(alice);
        hold(bob);
        seconds(20);
        hold(alice);
        hold(bob);
        assertEquals(List.of("held 5550101", "retrieved 5550101"), alice.news());
        bob.level = 4000;
        assertTrue(alice.hears());
    }

    @Test
    void aThirdCallerFindsTheNumberBusy() {
        bobTalksWithCarolAndHoldsAlice();
        Phone dave = new Phone("5550103", true);
        dave.dial(BOB);
        assertEquals(List.of("released 17"), dave.news());
    }

    @Test
    void nothingIsHeldWithoutACallAndWhileItRings() {
        assertFalse(alice.station.hold());
        alice.dial(BOB);
        assertFalse(alice.station.hold());
        assertFalse(bob.station.hold());
    }

    @Test
    void switchingOffEndsBothCalls() {
        bobTalksWithCarolAndHoldsAlice();
        bob.station.powerOff();
        settle();
        assertTrue(alice.news().get(0).startsWith("released"));
        assertTrue(carol.news().get(0).startsWith("released"));
        assertTrue(exchange.calls().isEmpty());
    }
}
