package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.process.RobotProcess;
import simrobot.process.Wander;
import simrobot.world.Position;
import vericommand.RobotStatus;

/** A robot with a process of its own, and the orders that end it. */
class AutonomyTest {
    private final ControlBench bench = new ControlBench();

    private void wander() {
        assertTrue(bench.robot.autonomy().begin(BehaviourKind.WANDER));
        bench.seconds(1);
        assertEquals(RobotStatus.MOVING, bench.robot.status());
    }

    @Test
    void aWandererIsMovingAndComesToNoWallAhead() {
        wander();
        bench.seconds(120);
        assertEquals(
                List.of("behaviour robot=robot value=wander", "status robot=robot value=Moving"),
                bench.lines("behaviour", "status"));
    }

    @Test
    void aValidOrderEndsItWaitsForStandstillAndIsVerifiedAsStopped() {
        wander();
        bench.control.message("5550100", "** #**20 **");
        assertEquals(BehaviourKind.NONE, bench.robot.autonomy().kind());
        assertEquals(List.of(), bench.lines("order"));
        bench.seconds(1);
        double stoodAt = bench.robot.xMeters();
        bench.seconds(5);
        assertEquals(0.2, bench.robot.xMeters() - stoodAt, 0.02);
        assertEquals(
                List.of(
                        "status robot=robot value=Stopped",
                        "order robot=robot text=**#**20** verdict=accepted",
                        "status robot=robot value=Moving",
                        "status robot=robot value=Stopped"),
                sinceBehaviourEnded());
    }

    private List<String> sinceBehaviourEnded() {
        return bench.lines("order", "status").stream().toList();
    }

    @Test
    void aStopOrderEndsItAndIsAnsweredWhenTheRobotStands() {
        wander();
        bench.control.message("5550100", "** ### **");
        bench.seconds(3);
        List<String> told = bench.lines("status", "order", "outcome");
        assertEquals("status robot=robot value=Stopped", told.get(1));
        assertEquals("order robot=robot text=**###** verdict=accepted", told.get(2));
        assertTrue(told.get(3).startsWith("outcome robot=robot tone=3"), told.get(3));
    }

    @ParameterizedTest
    @ValueSource(strings = {"** #** **", "** #*0 **", "hello"})
    void brokenOrdersAndReportsLeaveItAlone(String text) {
        wander();
        bench.control.message("5550100", text);
        assertEquals(BehaviourKind.WANDER, bench.robot.autonomy().kind());
        assertEquals(1, bench.lines("outcome").size());
    }

    @Test
    void anOrderThatComesWhileAnotherWaitsIsAnsweredBySix() {
        wander();
        bench.control.message("5550100", "** #**20 **");
        bench.control.message("5550101", "** #**30 **");
        assertEquals(List.of("order robot=robot text=**#**30** verdict=refused"), bench.lines("order"));
        bench.seconds(5);
        assertEquals(List.of("order robot=robot text=**#**20** verdict=accepted"), bench.lines("order"));
    }

    @Test
    void aStopKeepsAWaitingOrderFromMoving() {
        wander();
        bench.control.message("5550100", "** #**20 **");
        bench.control.message("5550101", "** ### **");
        bench.seconds(5);
        List<String> outcomes = bench.lines("outcome");
        assertEquals(2, outcomes.size());
        assertEquals("outcome robot=robot tone=8 text=\"Stopped by order after 0 of 20 cm\"", outcomes.get(0));
        assertTrue(outcomes.get(1).startsWith("outcome robot=robot tone=3"), outcomes.get(1));
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void anOrderWhoseCallIsLostWhileItWaitsIsDropped() {
        wander();
        bench.control.callBegan(1, "5550100");
        bench.press("**#**20**");
        bench.control.callEnded(16);
        bench.seconds(5);
        assertEquals(List.of(), bench.lines("order", "outcome"));
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertFalse(bench.robot.isUnderOrder());
    }

    @Test
    void motorsOffEndItForGood() {
        wander();
        bench.robot.setMotors(false);
        bench.robot.setMotors(true);
        bench.seconds(1);
        assertEquals(BehaviourKind.NONE, bench.robot.autonomy().kind());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void motorsOffWhileAnOrderWaitsRefuseIt() {
        wander();
        bench.control.message("5550100", "** #**20 **");
        bench.robot.setMotors(false);
        bench.seconds(1);
        assertEquals(List.of("outcome robot=robot tone=8 text=\"Not possible: no motors.\""), bench.lines("outcome"));
    }

    @Test
    void aRobotWithoutMotorsBeginsNone() {
        bench.robot.setMotors(false);
        assertFalse(bench.robot.autonomy().begin(BehaviourKind.WANDER));
    }

    @Test
    void brakingByHandEndsIt() {
        wander();
        bench.robot.brake();
        bench.seconds(3);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertEquals(BehaviourKind.NONE, bench.robot.autonomy().kind());
    }

    @Test
    void aProcessOfACallStaysTheCallsInItsNewVersionAndEndsWithTheCall() {
        bench.control.callBegan(1, "5550100");
        bench.press("**#*1**");
        bench.seconds(1);
        assertEquals(RobotStatus.MOVING, bench.robot.status());
        AtomicInteger begun = new AtomicInteger();
        bench.robot.autonomy().renew(new BehaviourKind("wander", around -> {
            begun.incrementAndGet();
            return RobotProcess.inPlace(new Wander(around.robotNumber()));
        }));
        bench.seconds(1);
        assertEquals(1, begun.get());
        assertEquals(RobotStatus.MOVING, bench.robot.status());
        bench.control.callEnded(16);
        bench.seconds(3);
        assertEquals(BehaviourKind.NONE, bench.robot.autonomy().kind());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void aNewVersionOfAnotherProcessAndOneOfAnEndedProcessDoNotBegin() {
        BehaviourKind version = new BehaviourKind("wall-follow", around -> {
            throw new AssertionError("begun");
        });
        wander();
        bench.robot.autonomy().renew(version);
        assertEquals(BehaviourKind.WANDER, bench.robot.autonomy().kind());
        bench.robot.autonomy().end();
        bench.robot.autonomy().renew(version);
        assertFalse(bench.robot.autonomy().isActive());
    }

    @Test
    void aProcessKeepsItsNumberWhenOthersComeAndGo() {
        BehaviourList list = bench.simulation.behaviours();
        list.put(new BehaviourKind("Mine", around -> RobotProcess.inPlace(new Wander(1))));
        assertEquals("Mine", bench.robot.processes().get(3));
        list.put(new BehaviourKind("Another", around -> RobotProcess.inPlace(new Wander(1))));
        bench.robot.startProcess(3, "");
        assertEquals("Mine", bench.robot.autonomy().kind().text());
        bench.robot.autonomy().end();
        bench.seconds(3);
        assertEquals(
                new TreeMap<>(Map.of(1, "wander", 2, "wall-follow", 3, "Mine", 4, "Another")), bench.robot.processes());
        list.remove("Another");
        bench.robot.startProcess(4, "");
        assertEquals("Another", bench.robot.autonomy().kind().text(), "as it was announced");
    }

    @Test
    void twoWanderersNeverOverlap() {
        bench.simulation.addRobot("other", new Position(-2, 0), 0).autonomy().begin(BehaviourKind.WANDER);
        wander();
        for (int second = 0; second < 300; second++) {
            bench.seconds(1);
            var other = bench.simulation.robots().get(1);
            double gap = Math.hypot(bench.robot.xMeters() - other.xMeters(), bench.robot.yMeters() - other.yMeters());
            assertTrue(gap >= 0.5, "gap " + gap + " after " + second + " s");
        }
    }
}
