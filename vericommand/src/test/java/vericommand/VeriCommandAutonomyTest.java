package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Orders to a robot that an autonomous behaviour moves. */
class VeriCommandAutonomyTest {
    private final Bench bench = Bench.autonomous().call();

    @Test
    void aMotionEndsTheBehaviourAndIsVerifiedAndExecutedWhenTheRobotStands() {
        bench.press("** #**20 **");
        assertEquals(List.of("under-way true"), bench.events());
        assertEquals(1, bench.robot.autonomyEnds);
        assertEquals(List.of(), bench.robot.started);
        assertTrue(bench.veri.isUnderWay());
        bench.robot.standAfterAutonomy(StatusEvent.MOTION_ENDED);
        assertEquals(List.of("order **#**20** accepted", "tone 6"), bench.events());
        assertEquals(List.of(new Instruction.Forward(20)), bench.robot.started);
        bench.robot.reachGoal();
        assertEquals(List.of("tone 3", "under-way false"), bench.events("tone", "under-way"));
    }

    @Test
    void anOrderIsVerifiedAgainstTheStatusInWhichTheRobotStands() {
        bench.press("** #**20 **");
        bench.robot.standAfterAutonomy(StatusEvent.TOUCHED);
        assertEquals(
                List.of(
                        "under-way true",
                        "order **#**20** refused",
                        "outcome 8 Not possible: collision.",
                        "tone 8",
                        "under-way false"),
                bench.events());
        assertEquals("8 Not possible: collision.", bench.shown.replies().get(0));
        assertFalse(bench.shown.underWay());
    }

    @Test
    void aReportLeavesTheBehaviourRunning() {
        bench.press("** #*0 **");
        assertEquals(List.of("tone 6"), bench.events("tone", "under-way"));
        assertEquals(0, bench.robot.autonomyEnds);
        assertTrue(bench.robot.autonomous);
    }

    @ParameterizedTest
    @ValueSource(strings = {"** ### **", "** #*0 ### **"})
    void aStopOrderEndsTheBehaviourAndIsAnsweredWhenTheRobotStands(String order) {
        bench.press(order);
        assertEquals(1, bench.robot.autonomyEnds);
        assertEquals(List.of("under-way true"), bench.events());
        bench.robot.standAfterAutonomy(StatusEvent.MOTION_ENDED);
        assertEquals(List.of("tone 3", "under-way false"), bench.events("tone", "under-way"));
    }

    @Test
    void aBrokenOrderLeavesTheBehaviourRunning() {
        bench.press("** #*A");
        assertEquals(List.of("tone 7"), bench.events("tone", "under-way"));
        assertEquals(0, bench.robot.autonomyEnds);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "** #**20 **|8 Stopped by order after 0 of 20 cm",
                "** #*#90 #**20 **|8 Stopped by order after 0 of 90 degrees, instruction 1 of 2",
                "** #*0 ### #**20 #*#5 **|8 Stopped by order after 0 of 20 cm, instruction 3 of 4"
            })
    void aStopWhileAnOrderWaitsForStandstillStopsThatOrderBeforeItBegins(String order, String reply) {
        bench.press(order);
        bench.events();
        bench.sms("** ### **");
        assertEquals(List.of("order **###** accepted"), bench.events());
        assertEquals(1, bench.robot.brakes);
        bench.robot.standAfterAutonomy(StatusEvent.MOTION_ENDED);
        String done = "3 Done: ###. Stopped at 1.200 0.500 m, heading 90.0.";
        assertEquals(
                List.of(
                        "order " + OrderText.keysOf(order) + " accepted",
                        "outcome " + reply,
                        "ended ###",
                        "outcome " + done,
                        "sms 5550101 " + done,
                        "under-way false"),
                bench.events());
        assertEquals(List.of(reply, done), bench.shown.replies().subList(0, 2));
        assertEquals(List.of(), bench.robot.started);
    }

    @Test
    void twoStopOrdersBeforeTheRobotStandsAreAnsweredEach() {
        bench.press("** ### **");
        bench.sms("** ### **");
        bench.robot.standAfterAutonomy(StatusEvent.MOTION_ENDED);
        assertEquals(
                List.of("sms 5550101 3 Done: ###. Stopped at 1.200 0.500 m, heading 90.0.", "tone 3"),
                bench.events("sms", "tone"));
    }

    @Test
    void standstillAnswersNothingWhileAnOrderWaitsForIt() {
        bench.press("** #**20 **");
        bench.press("** ### **");
        bench.events();
        bench.robot.machine.apply(StatusEvent.MOTION_ENDED);
        bench.veri.statusChanged();
        assertEquals(List.of(), bench.events());
    }

    @Test
    void anotherMotionBeforeTheRobotStandsIsAnsweredBySix() {
        bench.press("** #**20 **");
        bench.press("** #*#90 **");
        assertEquals(List.of("tone 6"), bench.events("tone"));
        bench.robot.standAfterAutonomy(StatusEvent.MOTION_ENDED);
        assertEquals(List.of(new Instruction.Forward(20)), bench.robot.started);
    }

    @Test
    void hangUpBeforeTheRobotStandsDropsTheOrder() {
        bench.press("** #**20 **");
        bench.events();
        bench.veri.callEnded();
        assertTrue(bench.shown.underWay());
        bench.robot.standAfterAutonomy(StatusEvent.MOTION_ENDED);
        assertEquals(List.of("under-way false"), bench.events());
        assertEquals(List.of(), bench.robot.started);
        assertFalse(bench.shown.underWay());
    }

    @Test
    void aRobotWithoutAutonomousBehavioursStandsAtOnce() {
        int[] calls = {0};
        Robot robot = new Robot() {
            @Override
            public RobotStatus status() {
                return RobotStatus.STOPPED;
            }

            @Override
            public void start(Instruction.Motion motion, java.util.function.Consumer<MotionOutcome> ended) {}

            @Override
            public void brake() {}

            @Override
            public Pose pose() {
                return new Pose(0, 0, 0);
            }
        };
        assertFalse(robot.isAutonomous());
        robot.endAutonomy(() -> calls[0]++);
        assertEquals(1, calls[0]);
    }
}
