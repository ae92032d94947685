package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/** What a window is given to show. */
class VeriCommandSnapshotTest {
    private final Bench bench = Bench.in(RobotStatus.STOPPED).call();

    private VeriCommandSnapshot shown() {
        return bench.veri.snapshot();
    }

    @Test
    void keysAreShownAsTheyCome() {
        bench.press("**#*");
        assertEquals("**#*", shown().keys());
        assertEquals("", shown().verdictWord());
        assertEquals(Bench.CALLER, shown().from());
        assertTrue(shown().inCall());
        assertEquals(OrderSource.CALL, shown().source());
    }

    @Test
    void aCompleteOrderIsShownInWordsWithItsVerdictAndReplies() {
        bench.press("** #**20 **");
        assertEquals("**#**20**", shown().keys());
        assertEquals("forward 20 cm", shown().words().in(Locale.ENGLISH));
        assertEquals("accepted", shown().verdictWord());
        assertTrue(shown().underWay());
        bench.robot.collide(3);
        assertEquals(List.of("4 Collision after 3 of 20 cm, instruction 1 of 1."), shown().replies());
        assertFalse(shown().underWay());
    }

    @Test
    void theCourseOfAnOrderTellsWhatHasBecomeOfIt() {
        assertEquals(OrderCourse.NONE, shown().course());
        bench.press("** #**20 **");
        assertEquals(OrderCourse.UNDER_WAY, shown().course());
        bench.robot.collide(3);
        assertEquals("accepted", shown().verdictWord());
        assertEquals(OrderCourse.COLLISION, shown().course());
        bench.press("**");
        assertEquals(OrderCourse.NONE, shown().course());
        bench.press("#**20 **");
        assertEquals("refused", shown().verdictWord());
        assertEquals(OrderCourse.NONE, shown().course());
        bench.press("** #*#90 **");
        bench.robot.reachGoal();
        assertEquals(OrderCourse.EXECUTED, shown().course());
        bench.press("** #*0 **");
        assertEquals(OrderCourse.EXECUTED, shown().course());
        bench.press("** #**20 **");
        bench.robot.end(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.INFINITE_LOOP, 3);
        assertEquals(OrderCourse.INFINITE_LOOP, shown().course());
        bench.press("** #**20 **");
        bench.robot.end(StatusEvent.MOTORS_OFF, MotionOutcome.Ending.ABORTED, 3);
        assertEquals(OrderCourse.BROKEN_OFF, shown().course());
    }

    @Test
    void aTripWhoseNextInstructionIsRefusedSaysSo() {
        Bench collided = Bench.in(RobotStatus.COLLISION).call();
        collided.press("** #*#90 #**20 **");
        collided.robot.end(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.DONE, 90);
        collided.robot.collide(1);
        assertEquals(OrderCourse.COLLISION, collided.veri.snapshot().course());
        bench.press("** #**20 #**20 **");
        bench.robot.machine.apply(StatusEvent.MOTION_ENDED);
        bench.robot.end(StatusEvent.MOTORS_OFF, MotionOutcome.Ending.DONE, 20);
        assertEquals(OrderCourse.NOT_POSSIBLE, shown().course());
    }

    @Test
    void aStoppedOrderThatIsNoLongerShownLeavesTheStopOrderItsCourse() {
        bench.press("** #**20 **");
        bench.press("** ### **");
        assertEquals(OrderCourse.UNDER_WAY, shown().course());
        bench.robot.stand(3);
        assertEquals("**###**", shown().keys());
        assertEquals(OrderCourse.EXECUTED, shown().course());
    }

    @Test
    void aBrakedOrderIsStopped() {
        bench.press("** #**20 **");
        bench.robot.stand(3);
        assertEquals(OrderCourse.STOPPED, shown().course());
    }

    @Test
    void aProcessIsUnderWayUntilItEnds() {
        bench.press("** #*1 **");
        assertEquals(OrderCourse.UNDER_WAY, shown().course());
        bench.veri.processEnded(ProcessEnding.COLLISION, "wander", "");
        assertEquals(OrderCourse.COLLISION, shown().course());
    }

    @Test
    void aBrokenOrderShowsItsFailingPositionUntilTheNextBegins() {
        bench.press("** #**0 **");
        VeriCommandSnapshot broken = shown();
        assertEquals("invalid", broken.verdictWord());
        assertEquals(7, broken.failingPosition());
        assertEquals(
                "Not a valid command: number expected at key 7. Range 1..9999 cm.",
                broken.verdictText().in(Locale.ENGLISH));
        assertEquals('*', "**#**0**".charAt(broken.failingPosition() - 1));
        bench.press("#");
        assertEquals(0, shown().failingPosition());
        assertEquals("**#", shown().keys());
    }

    @Test
    void aNewOrderReplacesTheShownOne() {
        bench.press("** #**20 **");
        bench.press("**");
        assertEquals("**", shown().keys());
        assertEquals("", shown().words().in(Locale.ENGLISH));
        assertEquals("", shown().verdictWord());
    }

    @Test
    void keysSkippedAfterAFaultAreShownToo() {
        bench.press("** 9 1 #");
        assertEquals("**91#", shown().keys());
        assertEquals(3, shown().failingPosition());
    }

    @Test
    void aNewCallOrMessageShowsNothingOfTheLastOne() {
        bench.press("** #**0 **");
        bench.veri.callBegan("5550102");
        assertEquals(
                new VeriCommandSnapshot(
                        "5550102",
                        OrderSource.CALL,
                        true,
                        false,
                        "",
                        LocalizedText.EMPTY,
                        "",
                        LocalizedText.EMPTY,
                        OrderCourse.NONE,
                        0,
                        List.of()),
                shown());
        bench.press("** #**0 **");
        bench.sms("** #*0 **");
        assertEquals("**#*0**", shown().keys());
        assertEquals(0, shown().failingPosition());
        assertEquals(1, shown().replies().size());
    }

    @Test
    void aLostCallStopsItsOrderAndTheSnapshotSaysSo() {
        bench.press("** #**20 **");
        bench.veri.callEnded();

        assertEquals("accepted", shown().verdictWord());
        assertEquals(OrderCourse.CALL_ENDED, shown().course());
        bench.robot.stand(3);
        assertEquals(OrderCourse.CALL_ENDED, shown().course());
        assertEquals("**#**20**", shown().keys());
    }

    @Test
    void aCallThatIsLostWithinAnOrderLeavesItUnfinished() {
        bench.press("** #*");
        bench.veri.callEnded();

        assertEquals(
                "The call ended before the order was whole.",
                shown().verdictText().in(Locale.ENGLISH));
        assertEquals(VeriCommandSnapshot.UNFINISHED, shown().verdictWord());
        assertEquals(OrderCourse.NONE, shown().course());
    }

    @Test
    void aCallThatIsClearedForWantOfAKeySaysSoInPlaceOfItsLastOrder() {
        bench.press("** #*0 **");
        bench.veri.callIdle(60);
        bench.veri.callEnded();

        assertEquals(VeriCommandSnapshot.IDLE, shown().verdictWord());
        assertEquals(
                "The call was ended: no key for 60 s.", shown().verdictText().in(Locale.ENGLISH));
        assertEquals(LocalizedText.EMPTY, shown().words());
        assertEquals(OrderCourse.NONE, shown().course());
        assertEquals(Bench.CALLER, shown().from());
        assertFalse(shown().inCall());
        bench.veri.callBegan(Bench.CALLER);
        assertEquals("", shown().verdictWord());
    }

    @Test
    void withoutACallNothingIsIdle() {
        bench.veri.callEnded();
        bench.veri.callIdle(60);
        assertEquals("", shown().verdictWord());
    }

    @Test
    void theWordsAreThereInBothLanguages() {
        bench.press("** #**20 **");
        assertEquals("forward 20 cm", shown().words().in(Locale.ENGLISH));
        assertEquals("avanzar 20 cm", shown().words().in(new Locale("es")));
        assertEquals("aceptada", shown().verdictText().in(new Locale("es")));
    }

    @Test
    void aCallThatEndsAfterItsOrderLeavesTheVerdict() {
        bench.press("** #*0 **");
        LocalizedText verdict = shown().verdictText();
        bench.veri.callEnded();

        assertEquals(verdict, shown().verdictText());
        assertEquals("accepted", shown().verdictWord());
    }

    @Test
    void everyChangeOfTheSnapshotIsNotified() {
        bench.veri.callEnded();
        Runnable[] inputs = {
            () -> bench.veri.callBegan("5550103"),
            () -> bench.veri.key('*'),
            () -> bench.press("* #*"),
            () -> bench.veri.speech(CommandRecognizer.TIMEOUT_SAMPLES),
            () -> bench.sms("** #**20 #*0 **"),
            () -> bench.robot.collide(5),
            () -> bench.veri.callEnded(),
            () -> bench.robot.machine.apply(StatusEvent.MOTION_STARTED),
            () -> bench.sms("** ### **"),
            () -> {
                bench.robot.machine.apply(StatusEvent.MOTION_ENDED);
                bench.veri.statusChanged();
            }
        };
        for (int i = 0; i < inputs.length; i++) {
            inputs[i].run();
            assertEquals(bench.veri.snapshot(), bench.shown, "after input " + i);
        }
    }

    @Test
    void speechWithoutATimeOutIsNoChange() {
        bench.press("** #");
        int before = bench.changes;
        bench.veri.speech(CommandRecognizer.TIMEOUT_SAMPLES - 1);
        assertEquals(before, bench.changes);
        bench.veri.speech(1);
        assertEquals(before + 1, bench.changes);
    }

    @Test
    void aMessageTakesTheLineAndTheCallTakesItBackWithItsNextKey() {
        bench.press("** #*");
        bench.sms("** #*#90 **");
        assertEquals(OrderSource.MESSAGE, shown().source());
        assertEquals("5550101", shown().from());
        assertEquals("turn right 90 degrees", shown().words().in(Locale.ENGLISH));
        bench.press("*");
        assertEquals(OrderSource.CALL, shown().source());
        assertEquals("**#**", shown().keys());
        assertEquals(Bench.CALLER, shown().from());
    }

    @Test
    void manyKeysAndRepliesStayBounded() {
        for (int i = 0; i < 500; i++) {
            bench.press("** 9 1 2 3 4 5 6 7 8");
        }
        bench.press("7".repeat(1000));
        assertEquals(320, shown().keys().length());
        assertEquals(8, shown().replies().size());
    }
}
