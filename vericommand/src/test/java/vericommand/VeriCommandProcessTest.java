package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Orders {@code #*1} to {@code #*99}, which start a process of the robot. */
class VeriCommandProcessTest {
    private static final String WHERE = "Stopped at 1.200 0.500 m, heading 90.0.";

    private final Bench bench = Bench.in(RobotStatus.STOPPED).call();

    private void ends(ProcessEnding ending) {
        bench.robot.autonomous = false;
        bench.robot.machine.apply(StatusEvent.MOTION_ENDED);
        bench.veri.processEnded(ending, "wander", "");
    }

    @Test
    void aProcessIsAnsweredBySixWhenItStartsAndByThreeWhenItHasReachedItsGoal() {
        bench.press("** #*1 **");
        assertEquals(List.of(1), bench.robot.processes);
        assertEquals(
                List.of("order **#*1** accepted", "outcome 6 Started process 1: wander.", "tone 6"),
                bench.events("order", "outcome", "tone"));
        ends(ProcessEnding.DONE);
        assertEquals(
                List.of("outcome 3 Done: wander. " + WHERE, "tone 3", "under-way false"),
                bench.events("outcome", "tone", "under-way"));
    }

    @Test
    void whileItRunsTheCallCountsAsBusySoTheModemDoesNotClearIt() {
        bench.press("** #*1 **");
        assertTrue(bench.veri.isUnderWay());
        ends(ProcessEnding.FAILED);
        assertFalse(bench.veri.isUnderWay());
    }

    @ParameterizedTest
    @CsvSource({"COLLISION,4 Collision in process wander.", "FAILED,5 Process wander ended: no way"})
    void bySmsItsStartAndItsEndAreAnsweredOnceEach(ProcessEnding ending, String reply) {
        bench.sms("** #*1 **");
        assertEquals(List.of("sms 5550101 6 Started process 1: wander."), bench.events("sms", "tone"));
        assertFalse(bench.veri.isUnderWay());
        bench.veri.processEnded(ending, "wander", "no way");
        bench.veri.processEnded(ProcessEnding.DONE, "wander", "");
        assertEquals(List.of("sms 5550101 " + reply), bench.events("sms", "tone"));
    }

    @Test
    void aTripMayEndWithAProcess() {
        bench.press("** #**20 #*2 **");
        bench.robot.reachGoal();
        assertEquals(List.of(2), bench.robot.processes);
        assertEquals(
                List.of("tone 6", "outcome 6 Started process 2: wall-follow.", "tone 6"),
                bench.events("tone", "outcome"));
    }

    @Test
    void aNumberWithoutAProcessIsNotAValidCommandAndTheReplyListsThoseThereAre() {
        bench.sms("** #**20 #*3 **");
        String reply = "7 Not a valid command: no process 3 at key 10. Processes: 1 wander, 2 wall-follow.";
        assertEquals(List.of("order **#**20#*3** invalid", "outcome " + reply, "sms 5550101 " + reply), bench.events());
        assertEquals(10, bench.shown.failingPosition());
        assertEquals(List.of(), bench.robot.started);
    }

    @ParameterizedTest
    @CsvSource({"** #*9 **,5", "*** #*9 **,6", "**** #*9 **,7", "***** #*9 **,8", "**** #**20 #*9 **,12"})
    void theKeyOfAProcessThatIsNotThereCountsAllStarsOfTheOpening(String keys, int position) {
        bench.sms(keys);
        bench.press(keys);
        String reply =
                "7 Not a valid command: no process 9 at key " + position + ". Processes: 1 wander, 2 wall-follow.";
        assertEquals(List.of("outcome " + reply, "outcome " + reply), bench.events("outcome"));
        assertEquals(OrderText.keysOf(keys), bench.shown.keys());
        assertEquals('9', bench.shown.keys().charAt(bench.shown.failingPosition() - 1));
    }

    @Test
    void aProcessOfTwoDigitsIsStarted() {
        bench.robot.available.put(42, "Circle");
        bench.press("** #*42 **");
        assertEquals(List.of(42), bench.robot.processes);
        assertEquals(List.of("outcome 6 Started process 42: Circle.", "tone 6"), bench.events("tone", "outcome"));
    }

    @Test
    void theNumbersOfManyProcessesAreListedAsRanges() {
        IntStream.rangeClosed(3, 40).forEach(number -> bench.robot.available.put(number, "Process" + number));
        bench.robot.available.put(98, "Last");
        bench.sms("** #*99 **");
        assertEquals(
                List.of("outcome 7 Not a valid command: no process 99 at key 5. Processes: 1-40, 98."),
                bench.events("outcome"));
    }

    @Test
    void aListOfNumbersThatIsTooLongForAMessageEndsWithDots() {
        IntStream.range(2, 50).forEach(number -> bench.robot.available.put(2 * number, "P"));
        bench.sms("** #*99 **");
        String reply = bench.events("outcome").get(0);
        assertTrue(reply.endsWith(", ..."), reply);
        assertTrue(reply.length() <= "outcome ".length() + 160, reply);
    }

    @Test
    void aNumberWithoutAProcessLeavesTheRunningOneAlone() {
        bench.press("** #*1 **");
        bench.press("** #*7 **");
        assertEquals(0, bench.robot.autonomyEnds);
        assertTrue(bench.robot.autonomous);
    }

    @ParameterizedTest
    @CsvSource({"COLLISION,8", "NO_MOTORS,8", "DISCONNECTED,2"})
    void itIsJudgedLikeAForwardMotion(RobotStatus status, int tone) {
        Bench other = Bench.in(status).call();
        other.press("** #*1 **");
        assertEquals(List.of("tone " + tone), other.events("tone"));
        assertEquals(List.of(), other.robot.processes);
    }

    @Test
    void whileAnOrderMovesTheRobotAProcessIsAnsweredBySix() {
        bench.press("** #**20 **");
        bench.events();
        bench.press("** #*1 **");
        assertEquals(List.of("outcome 6 Executing a command.", "tone 6"), bench.events("outcome", "tone"));
        assertEquals(List.of(), bench.robot.processes);
    }

    @Test
    void anotherOrderEndsItWithoutAToneForIt() {
        bench.press("** #*1 **");
        bench.events();
        bench.press("** #*2 **");
        bench.veri.processEnded(ProcessEnding.REPLACED, "wander", "");
        bench.robot.standAfterAutonomy(StatusEvent.MOTION_ENDED);
        assertEquals(List.of("outcome 6 Started process 2: wall-follow.", "tone 6"), bench.events("outcome", "tone"));
        assertEquals(List.of(1, 2), bench.robot.processes);
    }

    @Test
    void theEndOfTheCallBrakesTheProcessThatTheCallStarted() {
        bench.press("** #*1 **");
        bench.veri.callEnded();
        assertEquals(1, bench.robot.brakes);
        bench.events();
        ends(ProcessEnding.DONE);
        assertEquals(List.of(), bench.events("tone", "sms"));
    }

    @Test
    void aProcessStartedBySmsOutlivesACall() {
        bench.sms("** #*1 **");
        bench.veri.callEnded();
        assertEquals(0, bench.robot.brakes);
    }

    @Test
    void withFinishTheProcessOutlivesItsCall() {
        Bench other =
                Bench.with(Bench.settings(VeriCommandSettings.OnHangup.FINISH)).call();
        other.press("** #*1 **");
        other.veri.callEnded();
        assertEquals(0, other.robot.brakes);
    }

    @Test
    void theFailureOfAProcessThatNoOrderStartedIsShownOnly() {
        bench.veri.processEnded(ProcessEnding.FAILED, "goto Dock", "no way.");
        assertEquals(List.of("outcome 5 Process goto Dock ended: no way."), bench.events("outcome", "tone", "sms"));
    }
}
