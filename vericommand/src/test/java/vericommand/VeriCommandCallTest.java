package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Orders by keys in a call, answered by tones. */
class VeriCommandCallTest {
    @Test
    void thePapersExampleMovesTheRobotAndAnswersSixThenThree() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**20 **");
        assertEquals(List.of("order **#**20** accepted", "under-way true", "tone 6"), bench.events());
        assertEquals(List.of(new Instruction.Forward(20)), bench.robot.started);
        bench.robot.reachGoal();
        assertEquals(
                List.of(
                        "ended #**20",
                        "outcome 3 Done: #**20. Stopped at 1.200 0.500 m, heading 90.0.",
                        "tone 3",
                        "under-way false"),
                bench.events());
    }

    @ParameterizedTest
    @CsvSource({"STOPPED,1", "COLLISION,1", "MOVING,1", "NO_MOTORS,1", "DISCONNECTED,2"})
    void aCallerIsAcceptedUnlessTheRobotIsOff(RobotStatus status, char tone) {
        assertEquals(
                tone, VeriCommandSettings.DEFAULT.admission("5550100", status).key());
    }

    @Test
    void aCallerThatIsNoOperatorIsDeniedInEveryStatus() {
        VeriCommandSettings settings = Bench.settings(VeriCommandSettings.OnHangup.STOP, "5550101", "5550102");
        for (RobotStatus status : RobotStatus.values()) {
            assertEquals(ReplyTone.CONNECTION_DENIED, settings.admission("5550100", status));
        }
        assertEquals(ReplyTone.CONNECTION_DENIED, settings.admission("", RobotStatus.STOPPED));
        assertEquals(ReplyTone.CONNECTION_ACCEPTED, settings.admission("5550102", RobotStatus.STOPPED));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "COLLISION|**#**20**|8|Not possible: collision.",
                "NO_MOTORS|**#**20**|8|Not possible: no motors.",
                "NO_MOTORS|**#*#20**|8|Not possible: no motors.",
                "NO_MOTORS|**###**|8|Not possible: no motors.",
                "MOVING|**#**20**|6|Executing a command.",
                "MOVING|**#*#20**|6|Executing a command.",
                "MOVING|**####*#20**|6|Executing a command."
            })
    void anOrderThatTheStatusForbidsIsRefusedAndNothingMoves(
            RobotStatus status, String keys, String tone, String text) {
        Bench bench = Bench.in(status).call();
        bench.press(keys);
        assertEquals(
                List.of("order " + keys + " refused", "outcome " + tone + " " + text, "tone " + tone), bench.events());
        assertTrue(bench.robot.started.isEmpty());
        assertFalse(bench.veri.isUnderWay());
    }

    @ParameterizedTest
    @CsvSource({"STOPPED,3", "COLLISION,4", "MOVING,6", "NO_MOTORS,8"})
    void aReportIsTheToneOfTheStatus(RobotStatus status, String tone) {
        Bench bench = Bench.in(status).call();
        bench.press("**#*0**");
        List<String> events = bench.events();
        assertEquals("order **#*0** accepted", events.get(0));
        assertEquals("ended #*0", events.get(1));
        assertTrue(events.get(2).startsWith("outcome " + tone), events.toString());
        assertEquals(List.of("tone " + tone), events.subList(3, events.size()));
    }

    @Test
    void anOrderToARobotSwitchedOffDuringTheCallIsDeniedAndTheCallIsCleared() {
        Bench bench = Bench.in(RobotStatus.DISCONNECTED).call();
        bench.press("**#*0**");
        assertEquals(
                List.of("order **#*0** refused", "outcome 2 Connection denied: the robot is off.", "tone 2", "clear"),
                bench.events());
    }

    @Test
    void aTripReportsEachInstructionWhenItHasEnded() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** ### #**100 #*0 #*#90 **");
        assertEquals(List.of("ended ###"), bench.events("ended"));
        bench.robot.reachGoal();
        assertEquals(List.of("ended #**100", "ended #*0"), bench.events("ended"));
        bench.robot.reachGoal();
        assertEquals(List.of("ended #*#90"), bench.events("ended"));
    }

    @Test
    void aTripGoesOnInstructionByInstructionWithOneSixAndOneThree() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**100 #*0 #*#90 ### #**50 **");
        bench.robot.reachGoal();
        bench.robot.reachGoal();
        assertEquals(
                List.of(new Instruction.Forward(100), new Instruction.Turn(90), new Instruction.Forward(50)),
                bench.robot.started);
        bench.robot.reachGoal();
        assertEquals(List.of("tone 6", "tone 3"), bench.events("tone"));
    }

    @Test
    void aCollisionEndsTheTripWithFour() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #*#90 #**100 #**5 **");
        bench.robot.reachGoal();
        bench.events();
        bench.robot.collide(12.4);
        assertEquals(
                List.of(
                        "ended #**100",
                        "outcome 4 Collision after 12 of 100 cm, instruction 2 of 3.",
                        "tone 4",
                        "under-way false"),
                bench.events());
        assertEquals(2, bench.robot.started.size());
    }

    @Test
    void theWayOutOfACollisionIsATurnThenForward() {
        Bench bench = Bench.in(RobotStatus.COLLISION).call();
        bench.press("** #*#90 #**20 **");
        bench.robot.reachGoal();
        bench.robot.reachGoal();
        assertEquals(List.of("tone 6", "tone 3"), bench.events("tone"));
    }

    @Test
    void aTurnThatLeavesTheWayBlockedEndsTheOrderWithFour() {
        Bench bench = Bench.in(RobotStatus.COLLISION).call();
        bench.press("** #*#10 #**20 **");
        bench.robot.end(StatusEvent.TURN_ENDED_BLOCKED, MotionOutcome.Ending.COLLISION, 10);
        assertEquals(
                List.of("outcome 4 Collision after 10 of 10 degrees, instruction 1 of 2.", "tone 4"),
                bench.events("outcome", "tone").subList(1, 3));
        assertEquals(1, bench.robot.started.size());
    }

    @Test
    void theWatchdogEndsTheOrderWithFive() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**600 #**5 **");
        bench.robot.end(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.INFINITE_LOOP, 13);
        assertEquals(
                List.of("tone 6", "outcome 5 Infinite loop after 13 of 600 cm, instruction 1 of 2.", "tone 5"),
                bench.events("outcome", "tone"));
        assertEquals(1, bench.robot.started.size());
    }

    @Test
    void motorsSwitchedOffEndTheOrderWithEightAndSayHowFarItGot() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**30 #**600 **");
        bench.robot.reachGoal();
        bench.robot.end(StatusEvent.MOTORS_OFF, MotionOutcome.Ending.ABORTED, 250);
        assertEquals(
                List.of(
                        "tone 6",
                        "outcome 8 Not possible: no motors. Ended after 250 of 600 cm, instruction 2 of 2.",
                        "tone 8"),
                bench.events("outcome", "tone"));
    }

    @Test
    void powerSwitchedOffEndsTheOrderWithTwoAndClearsTheCall() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**600 **");
        bench.events();
        bench.robot.end(StatusEvent.POWER_OFF, MotionOutcome.Ending.ABORTED, 250);
        assertEquals(
                List.of(
                        "outcome 2 Connection denied: the robot is off. Ended after 250 of 600 cm, instruction 1 of 1.",
                        "tone 2",
                        "clear"),
                bench.events("outcome", "tone", "clear"));
    }

    @Test
    void anInstructionThatTheStatusRefusesLaterEndsTheTripAndSaysHowMuchIsDone() {
        Bench bench = Bench.in(RobotStatus.NO_MOTORS).call();
        bench.press("** #*0 #**20 **");
        assertEquals(
                List.of("outcome 8 Not possible: no motors. Done 1 of 2 instructions.", "tone 8"),
                bench.events("outcome", "tone"));
    }

    @Test
    void whileMovingEveryOtherOrderGetsOneSixAndTheFirstGoesOn() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**500 **");
        bench.press("** #*#90 **");
        bench.press("** #**20 #*0 **");
        assertEquals(List.of("tone 6", "tone 6", "tone 6"), bench.events("tone"));
        bench.press("** #*0 **");
        assertEquals(List.of("tone 6"), bench.events("tone"));
        assertEquals(1, bench.robot.started.size());
        bench.robot.reachGoal();
        assertEquals(List.of("tone 3"), bench.events("tone"));
    }

    @Test
    void stopBrakesAndIsAnsweredByThreeWhenTheRobotStandsTheStoppedOrderByNothing() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**500 #*#90 **");
        bench.events();
        bench.press("** ### **");
        assertEquals(List.of("order **###** accepted"), bench.events());
        assertEquals(1, bench.robot.brakes);
        assertTrue(bench.veri.isUnderWay());
        bench.robot.stand(123.4);
        assertEquals(
                List.of(
                        "ended #**500",
                        "outcome 8 Stopped by order after 123 of 500 cm, instruction 1 of 2",
                        "ended ###",
                        "outcome 3 Done: ###. Stopped at 1.200 0.500 m, heading 90.0.",
                        "tone 3",
                        "under-way false"),
                bench.events());
        assertEquals(1, bench.robot.started.size());
    }

    @Test
    void stopAndReportInOneOrderIsAStopOrder() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**500 **");
        bench.press("** #*0 ### **");
        bench.robot.stand(7);
        assertEquals(List.of("tone 6", "tone 3"), bench.events("tone"));
    }

    @Test
    void stopThatComesAsTheGoalIsReachedEndsTheTripThere() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**20 #*#90 **");
        bench.press("** ### **");
        bench.robot.reachGoal();
        assertEquals(List.of("tone 6", "tone 3"), bench.events("tone"));
        assertEquals(1, bench.robot.started.size());
    }

    @Test
    void anOrderThatReachesItsGoalThoughStopWasOrderedIsDone() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**20 #*#90 **");
        bench.robot.reachGoal();
        bench.press("** ### **");
        bench.robot.reachGoal();
        assertEquals(
                List.of(
                        "outcome 3 Done: #**20 #*#90. Stopped at 1.200 0.500 m, heading 90.0.",
                        "outcome 3 Done: ###. Stopped at 1.200 0.500 m, heading 90.0."),
                bench.events("outcome"));
    }

    /** "3 when the robot stands; the order that it stopped gets no tone": for whatever reason it stands. */
    @ParameterizedTest
    @CsvSource({"COLLISION, TOUCHED", "INFINITE_LOOP, MOTION_ENDED", "ABORTED, MOTORS_OFF"})
    void howeverTheMotionEndsWhileBrakingTheStoppedOrderHasNoToneAndStopIsAnsweredByThree(
            MotionOutcome.Ending kind, StatusEvent event) {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**500 **");
        bench.press("** ### **");
        bench.robot.end(event, kind, 40);
        assertEquals(List.of("tone 6", "tone 3"), bench.events("tone"));
    }

    @Test
    void aCollisionWhileBrakingIsStillReportedByMessage() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.sms("** #**500 **");
        bench.press("** ### **");
        bench.robot.collide(40);
        assertEquals(
                List.of("sms 5550101 4 Collision after 40 of 500 cm, instruction 1 of 1.", "tone 3"),
                bench.events("sms", "tone"));
    }

    @Test
    void powerOffWhileBrakingDeniesTheStopOnceAndClears() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**500 **");
        bench.press("** ### **");
        bench.robot.end(StatusEvent.POWER_OFF, MotionOutcome.Ending.ABORTED, 40);
        assertEquals(List.of("tone 6", "tone 2", "clear"), bench.events("tone", "clear"));
    }

    @Test
    void twoStopOrdersAreAnsweredEach() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**500 **");
        bench.press("** ### **");
        bench.press("** ### **");
        bench.robot.stand(9);
        assertEquals(List.of("tone 6", "tone 3", "tone 3"), bench.events("tone"));
    }

    @ParameterizedTest
    @CsvSource({"STOPPED", "COLLISION"})
    void stopOfAStandingRobotIsDoneAtOnce(RobotStatus status) {
        Bench bench = Bench.in(status).call();
        bench.press("** ### **");
        assertEquals(List.of("tone 3"), bench.events("tone"));
        assertFalse(bench.veri.isUnderWay());
    }

    @Test
    void stopOfARobotThatMovesByItselfIsAnsweredWhenItStands() {
        Bench bench = Bench.in(RobotStatus.MOVING).call();
        bench.press("** ### **");
        assertEquals(1, bench.robot.brakes);
        assertEquals(List.of("order **###** accepted", "under-way true"), bench.events());
        bench.veri.statusChanged();
        assertEquals(List.of(), bench.events());
        bench.robot.machine.apply(StatusEvent.MOTION_ENDED);
        bench.veri.statusChanged();
        assertEquals(List.of("tone 3"), bench.events("tone"));
        assertFalse(bench.veri.isUnderWay());
    }

    @Test
    void hangUpBrakesAndNothingIsAnsweredNotEvenInTheNextCall() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**500 #*#90 **");
        bench.veri.callEnded();
        assertEquals(1, bench.robot.brakes);
        bench.events();
        bench.call();
        bench.robot.stand(30);
        assertEquals(List.of("ended #**500", "under-way false"), bench.events());
        assertEquals(1, bench.robot.started.size());
        bench.press("** #*#5 **");
        assertEquals(List.of("tone 6"), bench.events("tone"));
    }

    @Test
    void onHangupFinishLetsTheInstructionEndButNoFurtherOneBegin() {
        Bench bench =
                Bench.with(Bench.settings(VeriCommandSettings.OnHangup.FINISH)).call();
        bench.press("** #**500 #*#90 **");
        bench.veri.callEnded();
        assertEquals(0, bench.robot.brakes);
        bench.events();
        bench.robot.reachGoal();
        assertEquals(List.of("ended #**500", "under-way false"), bench.events());
        assertEquals(1, bench.robot.started.size());
    }

    @Test
    void aStopOrderedBeforeTheHangUpStillStops() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**500 **");
        bench.press("** ### **");
        bench.veri.callEnded();
        bench.events();
        bench.robot.stand(3);
        assertEquals(List.of(), bench.events("tone", "outcome", "sms"));
    }

    @Test
    void aSecondCallEndsTheFirst() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**500 **");
        bench.press("** #*");
        bench.events();
        bench.veri.callBegan("5550102");
        assertEquals(1, bench.robot.brakes);
        bench.press("0 **");
        bench.robot.stand(30);
        assertEquals(List.of("ended #**500", "under-way false"), bench.events());
    }

    @Test
    void hangUpInTheMiddleOfAnOrderForgetsIt() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**2");
        bench.veri.callEnded();
        bench.call();
        bench.press("0 **");
        assertEquals(List.of(), bench.events());
    }

    @Test
    void aBrokenOrderGetsOneSevenAtTheOffendingKey() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #** *");
        assertEquals(
                List.of(
                        "order **#*** invalid",
                        "outcome 7 Not a valid command: number expected at key 6. Range 1..9999 cm.",
                        "tone 7"),
                bench.events());
        bench.press("*");
        bench.press("** #*#5 **");
        assertEquals(List.of("tone 6"), bench.events("tone"));
    }

    @Test
    void tenSecondsOfSpeechDropAnUnfinishedOrderWithSeven() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** #**20");
        for (int frame = 1; frame < 500; frame++) {
            bench.veri.speech(160);
        }
        assertEquals(List.of(), bench.events());
        bench.veri.speech(160);
        assertEquals(
                List.of(
                        "order **#**20 invalid",
                        "outcome 7 Not a valid command: digit or # or * expected at key 8. No key for 10 s.",
                        "tone 7"),
                bench.events());
    }

    @Test
    void anEmptyOrderNeverReplies() {
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("** **");
        bench.veri.speech(10 * CommandRecognizer.TIMEOUT_SAMPLES);
        bench.veri.callEnded();
        bench.press("**#**20**");
        assertEquals(List.of(), bench.events());
    }

    @Test
    void everyToneFromOneToEightCanBeHeard() {
        Set<ReplyTone> admissions = Set.of(
                VeriCommandSettings.DEFAULT.admission("", RobotStatus.STOPPED),
                VeriCommandSettings.DEFAULT.admission("", RobotStatus.DISCONNECTED));
        assertEquals(Set.of(ReplyTone.CONNECTION_ACCEPTED, ReplyTone.CONNECTION_DENIED), admissions);
        Bench bench = Bench.in(RobotStatus.STOPPED).call();
        bench.press("**#**1**");
        bench.robot.reachGoal();
        bench.press("**#**9**");
        bench.robot.end(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.INFINITE_LOOP, 0);
        bench.press("**#**9**");
        bench.robot.collide(0);
        bench.press("**#**9**");
        bench.press("**9");
        assertEquals(
                List.of("tone 6", "tone 3", "tone 6", "tone 5", "tone 6", "tone 4", "tone 8", "tone 7"),
                bench.events("tone"));
    }
}
