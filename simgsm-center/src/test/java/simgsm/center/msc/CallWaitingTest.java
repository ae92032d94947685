package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** A second call to a phone in a call. */
class CallWaitingTest extends ThreePhones {
    CallWaitingTest() {
        super(true);
    }

    @Test
    void aSecondCallWaitsAndRingsWhenTheFirstHasEnded() {
        aliceTalksWithBob();
        carol.dial(BOB);
        assertEquals(List.of("waiting 5550102"), bob.news());
        assertEquals(List.of("alerting"), carol.news());
        bob.station.hangUp();
        settle();
        assertEquals(List.of("released 16", "ringing 5550102"), bob.news());
        assertEquals(List.of("released 16"), alice.news());
        bob.station.answer();
        settle();
        assertEquals(List.of("connected 5550102"), bob.news());
        assertEquals(List.of("connected 5550101"), carol.news());
        carol.station.hangUp();
        settle();
        assertEquals(List.of("released 16"), bob.news());
        assertTrue(exchange.calls().isEmpty());
    }

    @Test
    void whenTheFirstCallersHangsUpTheSecondRings() {
        aliceTalksWithBob();
        carol.dial(BOB);
        bob.news();
        alice.station.hangUp();
        settle();
        assertEquals(List.of("released 16", "ringing 5550102"), bob.news());
    }

    @Test
    void whoWaitedAndGivesUpLeavesTheFirstCallAlone() {
        aliceTalksWithBob();
        carol.dial(BOB);
        carol.station.hangUp();
        settle();
        assertEquals(List.of("waiting 5550102", "waiting over"), bob.news());
        assertEquals(1, exchange.calls().size());
        alice.dial(CAROL);
        bob.station.hangUp();
        settle();
        assertEquals(List.of("released 16"), bob.news());
    }

    @Test
    void aThirdCallFindsTheNumberBusy() {
        aliceTalksWithBob();
        carol.dial(BOB);
        Phone dave = new Phone("5550103", true);
        dave.dial(BOB);
        assertEquals(List.of("released 17"), dave.news());
        assertEquals(List.of("waiting 5550102"), bob.news());
    }

    @Test
    void whoRingsButDoesNotTalkYetIsBusy() {
        alice.dial(BOB);
        carol.dial(BOB);
        assertEquals(List.of("released 17"), carol.news());
    }

    @Test
    void aTerminalThatTakesNoWaitingCallAnswersBusyItself() {
        Phone robot = new Phone("5550200", false);
        alice.dial("5550200");
        robot.station.answer();
        settle();
        carol.dial("5550200");
        assertEquals(List.of("released 17"), carol.news());
        assertEquals(List.of("ringing 5550100", "connected 5550100"), robot.news());
    }

    @Test
    void whoWaitsThreeMinutesIsReleasedWithCause19() {
        aliceTalksWithBob();
        carol.dial(BOB);
        for (int i = 0; i < 1_000; i++) {
            settle();
        }
        assertEquals(List.of("alerting", "released 19"), carol.news());
        assertEquals(List.of("waiting 5550102", "waiting over"), bob.news());
        assertEquals(1, exchange.calls().size());
    }

    @Test
    void aWaitingRequestEndsWhenTheMobileIsGone() {
        aliceTalksWithBob();
        carol.dial(BOB);
        carol.news();
        bob.station.powerOff();
        settle();
        assertTrue(carol.news().get(0).startsWith("released "), "still waits");
        assertTrue(exchange.calls().isEmpty());
    }
}
