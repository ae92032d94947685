package simrobot.pioneer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simrobot.behaviour.Steering;
import simrobot.p2os.P2osCommand;
import simrobot.p2os.P2osCommandNumber;
import simrobot.process.BehaviourKind;
import simrobot.process.Decision;
import simrobot.process.RobotProcess;
import simrobot.route.Destinations;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;

/** Processes in a real robot, which they steer over its line. */
class RealProcessesTest {
    private static final World ROOM = World.of(
            "room",
            List.of(
                    new Segment(-3, -3, 3, -3),
                    new Segment(3, -3, 3, 3),
                    new Segment(3, 3, -3, 3),
                    new Segment(-3, 3, -3, -3),
                    new Segment(1, -1.5, 1, 1.5)));

    private static BehaviourKind kind(String name, RobotProcess process) {
        return new BehaviourKind(name, around -> process);
    }

    private static BehaviourKind steering(double metersPerSecond, double radiansPerSecond) {
        return kind("steering", senses -> new Decision.Go(new Steering(metersPerSecond, radiansPerSecond)));
    }

    private static LineBench wandering() {
        LineBench bench = LineBench.connected(ROOM);
        assertTrue(bench.robot.autonomy().begin(BehaviourKind.WANDER));
        return bench;
    }

    @Test
    void wanderDrivesARealRobotBySonarAndItsStatusIsMovingAllTheTime() {
        LineBench bench = wandering();
        double meters = 0;
        for (int i = 0; i < 600; i++) {
            double x = bench.body.xMeters();
            double y = bench.body.yMeters();
            bench.seconds(0.1);
            meters += Math.hypot(bench.body.xMeters() - x, bench.body.yMeters() - y);
            assertEquals(RobotStatus.MOVING, bench.robot.status());
        }
        assertTrue(meters > 8, "drove " + meters + " m in 60 s");
        assertEquals(BehaviourKind.WANDER, bench.robot.snapshot().behaviour());
    }

    @Test
    void goToReachesItsPlaceRoundAWall() {
        LineBench bench = LineBench.connected(ROOM);
        List<Decision.End> ends = new ArrayList<>();
        bench.robot.autonomy().addEndListener((kind, how) -> ends.add(how));
        Destinations destinations = new Destinations();
        destinations.setExecutor(Runnable::run);
        assertTrue(bench.robot.autonomy().begin(destinations.to("there", new Position(2, 0))));
        bench.seconds(0.5);
        assertFalse(bench.robot.snapshot().path().isEmpty());
        for (int i = 0; i < 100 && ends.isEmpty(); i++) {
            bench.seconds(1);
        }
        assertInstanceOf(Decision.Arrived.class, ends.get(0));
        assertEquals(2, bench.body.xMeters(), 0.05);
        assertEquals(0, bench.body.yMeters(), 0.05);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void anOrderEndsTheProcessAndIsExecutedFromStandstill() {
        LineBench bench = wandering();
        bench.seconds(3);
        List<RobotStatus> standing = new ArrayList<>();
        bench.robot.endAutonomy(() -> standing.add(bench.robot.status()));
        assertFalse(bench.robot.isAutonomous());
        assertEquals(List.of(), standing, "it rolls out");
        bench.seconds(3);
        assertEquals(List.of(RobotStatus.STOPPED), standing);
        assertEquals(
                MotionOutcome.Ending.DONE, bench.order(new Instruction.Turn(90)).ending());
    }

    @Test
    void aProcessThatSteersIntoAWallIsInCollisionAndEndsAfterThreeSeconds() {
        LineBench bench = LineBench.connected(ROOM);
        List<Decision.End> ends = new ArrayList<>();
        bench.robot.autonomy().addEndListener((kind, how) -> ends.add(how));
        bench.robot.autonomy().begin(steering(0.3, 0));
        bench.seconds(6);
        assertEquals(RobotStatus.COLLISION, bench.robot.status());
        bench.seconds(3);
        assertInstanceOf(Decision.Collided.class, ends.get(0));
        assertEquals(0.75, bench.body.xMeters(), 0.01);
    }

    @Test
    void aProcessBacksAwayFromWhatItTouches() {
        LineBench bench = LineBench.connected(ROOM);
        bench.robot
                .autonomy()
                .begin(kind("back", senses -> new Decision.Go(new Steering(senses.xMeters() > 0.7 ? -0.3 : 0.3, 0))));
        bench.seconds(20);
        assertTrue(bench.statuses.contains(RobotStatus.COLLISION), bench.statuses.toString());
        assertTrue(bench.robot.isAutonomous());
        assertTrue(bench.statuses.lastIndexOf(RobotStatus.MOVING) > bench.statuses.indexOf(RobotStatus.COLLISION));
    }

    @Test
    void aLostLineEndsTheProcessAndTheRobotGetsStopWhenItIsBack() {
        LineBench bench = wandering();
        bench.seconds(2).cutLine();
        assertFalse(bench.robot.isAutonomous());
        assertEquals(RobotStatus.DISCONNECTED, bench.robot.status());
        bench.sent.clear();
        bench.connect();
        assertEquals(P2osCommandNumber.STOP, bench.sent.get(0)[3]);
        bench.seconds(3);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertFalse(bench.robot.autonomy().isActive());
    }

    @Test
    void motorsOffEndTheProcessAndWithoutMotorsNoneBegins() {
        LineBench bench = wandering();
        bench.seconds(1);
        bench.robot.setMotors(false);
        assertFalse(bench.robot.isAutonomous());
        bench.seconds(1);
        assertFalse(bench.robot.autonomy().begin(BehaviourKind.WANDER));
        assertEquals(RobotStatus.NO_MOTORS, bench.robot.status());
    }

    @Test
    void withoutInformationForHalfASecondTheRobotGetsStop() {
        LineBench bench = LineBench.connected(ROOM);
        bench.robot.autonomy().begin(steering(0.2, 0.5));
        bench.seconds(1);
        bench.sent.clear();
        byte[] stop = P2osCommand.packet(P2osCommandNumber.STOP);
        bench.deaf = true;
        bench.seconds(1);
        assertEquals(
                1,
                bench.sent.stream()
                        .filter(packet -> java.util.Arrays.equals(packet, stop))
                        .count());
        bench.deaf = false;
        assertEquals(0, bench.body.speedMetersPerSecond());
        bench.seconds(2);
        assertEquals(0.2, bench.body.speedMetersPerSecond(), 0.01, "it goes on");
    }

    @Test
    void aRealRobotHasNoLaserHere() {
        LineBench bench = LineBench.connected(ROOM);
        assertThrows(UnsupportedOperationException.class, () -> bench.robot.laserMeters(90));
    }
}
