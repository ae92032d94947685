package simrobot.app.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import simrobot.process.BehaviourKind;
import simrobot.process.Decision;
import simrobot.process.RobotProcess;
import simrobot.simulation.Simulation;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

/** How a run says that a robot has ended. */
class RunJudgeTest {
    private static final World WORLD = World.of(
            "lane",
            List.of(
                    new Segment(3, -1, 3, 1),
                    new Home("Start", new Position(0, 0), 0),
                    new Goal("Goal", "Finish", new Position(2, 0), 0)));

    private final Simulation simulation = new Simulation(WORLD, 1);

    /** Drives ahead until a decision ends it. */
    private static BehaviourKind ahead(double until, Decision end) {
        return new BehaviourKind("Ahead", around -> (RobotProcess) senses -> decision(senses, until, end));
    }

    private static Decision decision(Senses senses, double until, Decision end) {
        return senses.xMeters() > until ? end : new Decision.Go(new Steering(0.5, 0));
    }

    private RunJudge judge(BehaviourKind kind, String goal) {
        simulation.addRobot("anna");
        RunJudge judge = new RunJudge(
                simulation,
                kind,
                Optional.of(goal).filter(name -> !name.isEmpty()).map(name -> RunGoal.named(WORLD, name)));
        simulation.robots().get(0).setPower(true);
        simulation.robots().get(0).setMotors(true);
        judge.begin();
        for (int step = 0; step < 1500 && !judge.isDecided(); step++) {
            simulation.step();
        }
        judge.end(RunOutcome.State.TIMEOUT, "");
        return judge;
    }

    private String outcome(BehaviourKind kind, String goal) {
        return judge(kind, goal).outcomes().get(0).event().toString();
    }

    @Test
    void aProcessThatSaysSoIsDone() {
        RunJudge judge = judge(ahead(1, new Decision.Done(List.of())), "");
        RunOutcome outcome = judge.outcomes().get(0);
        assertEquals(RunOutcome.State.DONE, outcome.state());
        assertEquals(1.45, outcome.meters(), 0.1, "with the way of braking");
        assertTrue(outcome.seconds() > 2 && outcome.seconds() < 5, "" + outcome.seconds());
        assertTrue(judge.isAllDone());
        assertTrue(judge.row(7).matches("7,done,1,1,[0-9.]+,1\\.[0-9]+,0,"), judge.row(7));
    }

    @Test
    void withAGoalARobotIsDoneWithin30CentimetresOfIt() {
        RunOutcome outcome = judge(ahead(100, null), "Finish").outcomes().get(0);
        assertEquals(RunOutcome.State.DONE, outcome.state());
        assertEquals(1.7, outcome.meters(), 0.02);
    }

    @Test
    void aRobotThatStartsAtItsGoalMustLeaveItFirst() {
        assertTrue(outcome(ahead(100, null), "Start").contains(" state=collision "));
    }

    @Test
    void aProcessThatSaysItIsDoneFarFromItsGoalHasFailed() {
        String outcome = outcome(ahead(0.5, new Decision.Done(List.of())), "Finish");
        assertTrue(outcome.contains(" state=failed "), outcome);
        assertTrue(outcome.matches(".*text=\"says that it is done, 1\\.[0-9]{3} m from Finish\""), outcome);
    }

    @Test
    void aFaultIsToldWithItsLine() {
        RunJudge judge = judge(ahead(0.5, new Decision.Failed(4, "a \"fault\", told")), "");
        assertFalse(judge.isAllDone());
        assertTrue(judge.row(1).endsWith(",0,\"line 4: a \"\"fault\"\", told\""), judge.row(1));
        Grade grade = new Grade("Ahead", List.of(judge.row(1), "2,done,1,1,4.000,1.000,0,"));
        assertEquals("failed: line 4: a \"fault\", told", grade.text());
        assertEquals(1, grade.done());
        assertEquals(4, grade.meanSeconds());
        assertTrue(Grade.isRow(judge.row(-1)));
    }

    @Test
    void aRobotThatStaysInCollisionAndOneThatNeverEndsAreTold() {
        String outcome = outcome(ahead(100, null), "");
        assertTrue(outcome.endsWith("text=\"in collision for 3 s\""), outcome);
        assertTrue(judgeOfStanding().contains(" state=timeout seconds=15.000 meters=0.000 "));
    }

    private static String judgeOfStanding() {
        BehaviourKind standing = new BehaviourKind("Stand", around -> RobotProcess.inPlace(senses -> Steering.STOP));
        return new RunJudgeTest().outcome(standing, "Finish");
    }

    @Test
    void anUnknownGoalIsRefusedWithTheNamesThatThereAre() {
        assertEquals(
                "expected a home or goal of the world (Finish, Start), found X",
                assertThrows(IllegalArgumentException.class, () -> RunGoal.named(WORLD, "X"))
                        .getMessage());
    }
}
