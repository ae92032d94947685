package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Orders of programs, whose course is reported step by step. */
class ProgramOrdersTest {
    private static final String WHERE = "Stopped at 1.200 0.500 m, heading 90.0.";

    private final List<String> reports = new ArrayList<>();

    private void order(Bench bench, String keys) {
        bench.veri.order("ana", keys, report -> {
            reports.add(report.state()
                    + report.verdict().map(word -> " " + word).orElse("")
                    + report.reply().map(reply -> " " + reply.message()).orElse(""));
        });
    }

    private List<String> reports() {
        List<String> newest = List.copyOf(reports);
        reports.clear();
        return newest;
    }

    @Test
    void anOrderWaitsMovesAndEndsWithoutToneOrMessage() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        order(bench, "** #**20 #*#90 **");
        assertEquals(List.of("WAITING", "WAITING accepted", "MOVING accepted"), reports());
        bench.robot.reachGoal();
        bench.robot.reachGoal();
        assertEquals(List.of("ENDED accepted 3 Done: #**20 #*#90. " + WHERE), reports());
        assertEquals(List.of(), bench.events("tone", "sms"));
        assertEquals(OrderSource.PROGRAM, bench.shown.source());
        assertEquals("ana", bench.shown.from());
        assertEquals(List.of("3 Done: #**20 #*#90. " + WHERE), bench.shown.replies());
    }

    @Test
    void whileAnotherOrderMovesTheRobotAnOrderIsRefusedAndAStopEndsBoth() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        bench.sms("** #**20 **");
        order(bench, "** #*#90 **");
        assertEquals(List.of("WAITING", "WAITING refused", "ENDED refused 6 Executing a command."), reports());
        order(bench, "** ### **");
        assertEquals(List.of("WAITING", "WAITING accepted"), reports());
        bench.robot.end(StatusEvent.MOTION_ENDED, MotionOutcome.Ending.BRAKED, 5);
        assertEquals(List.of("ENDED accepted 3 Done: ###. " + WHERE), reports());
    }

    @Test
    void keysThatAreNoOrderEndAtOnceWithPositionAndWhatWasExpected() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        order(bench, "** #**0 **");
        assertEquals(
                List.of(
                        "WAITING",
                        "WAITING invalid",
                        "ENDED invalid 7 Not a valid command: number expected at key 7. Range 1..9999 cm."),
                reports());
    }

    @Test
    void anOrderThatEndsAProcessIsVerifiedOnceTheRobotStandsAndTheProcessOfAnOrderEndsWithoutReply() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        order(bench, "** #*1 **");
        assertEquals(List.of("WAITING", "WAITING accepted", "MOVING accepted 6 Started process 1: wander."), reports());
        order(bench, "** #**20 **");
        assertEquals(List.of("WAITING"), reports());
        bench.veri.processEnded(ProcessEnding.REPLACED, "wander", "");
        assertEquals(List.of("ENDED accepted 6 Started process 1: wander."), reports());
        bench.robot.standAfterAutonomy(StatusEvent.MOTION_ENDED);
        assertEquals(List.of("WAITING accepted", "MOVING accepted"), reports());
    }

    @Test
    void theProcessOfAnOrderIsAnsweredAgainWhenItEnds() {
        Bench bench = Bench.in(RobotStatus.STOPPED);
        order(bench, "** #*1 **");
        reports();
        bench.veri.processEnded(ProcessEnding.DONE, "wander", "");
        assertEquals("ENDED accepted 3 Done: wander.", reports().get(0).substring(0, 30));
    }
}
