package simrobot.pioneer;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.p2os.P2osCommand;
import simrobot.p2os.P2osCommandNumber;
import simrobot.p2os.P2osPacket;
import simrobot.robot.Bumpers;
import simrobot.robot.Placement;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.Pose;
import vericommand.RobotStatus;

/** The core that drives real robots, with our own P2OS session at the other end, or a peer made by hand. */
class RealPioneerTest {
    private static final World WALL_AHEAD = World.of("wall", List.of(new Segment(1, -9, 1, 9)));

    // ---- coming and going ------------------------------------------------------------------------------------------

    @Test
    void itIsDisconnectedUntilTheRobotTellsOfItselfThenItsMotorsAreSwitchedOn() {
        LineBench bench = new LineBench(World.bare());
        assertEquals(RobotStatus.DISCONNECTED, bench.robot.status());
        bench.connect();
        bench.seconds(0.5);
        assertEquals(List.of(RobotStatus.NO_MOTORS, RobotStatus.STOPPED), bench.statuses);
    }

    @Test
    void aLostLineIsDisconnectedAndAbortsWhatIsUnderWayAndItsReturnGoesOnFromThere() {
        LineBench bench = LineBench.connected(World.bare());
        bench.robot.start(new Instruction.Forward(200), bench.outcomes::add);
        bench.seconds(2).cutLine();
        assertEquals(RobotStatus.DISCONNECTED, bench.robot.status());
        assertEquals(MotionOutcome.Ending.ABORTED, bench.outcomes.get(0).ending());
        double there = bench.robot.pose().xMeters();
        assertTrue(there > 0.3, "at " + there);
        bench.seconds(5);
        double rolledOut = bench.body.xMeters();
        bench.connect();
        bench.seconds(0.5);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertEquals(there, bench.robot.pose().xMeters(), 1e-9);
        assertEquals(
                MotionOutcome.Ending.DONE,
                bench.order(new Instruction.Forward(10)).ending());
        assertEquals(rolledOut + 0.1, bench.body.xMeters(), 0.002);
    }

    @Test
    void aRobotThatFallsSilentIsGivenUpAfterThreeSeconds() {
        Peer peer = new Peer().open();
        peer.seconds(2.9);
        assertEquals(0, peer.drops);
        peer.seconds(0.3);
        assertEquals(1, peer.drops);
    }

    @Test
    void eachStepOfTheHandshakeIsRepeatedAfterASecondAndGivenUpAfterTenSilentTries() {
        Peer peer = new Peer();
        peer.robot.connected(peer.nanos);
        peer.seconds(9.9);
        assertEquals(10, peer.sent(P2osCommandNumber.PULSE));
        assertEquals(0, peer.drops);
        peer.seconds(2);
        assertEquals(1, peer.drops);
    }

    @Test
    void aRobotWithAnOpenSessionIsClosedAndAskedAgain() {
        Peer peer = new Peer();
        peer.robot.connected(peer.nanos);
        peer.say(Peer.standing());
        assertEquals(1, peer.sent(P2osCommandNumber.CLOSE));
        assertEquals(2, peer.sent(P2osCommandNumber.PULSE));
    }

    @Test
    void aSignOfLifeGoesOutEveryHalfSecond() {
        Peer peer = new Peer().open();
        int before = peer.sent(P2osCommandNumber.PULSE);
        for (int i = 0; i < 50; i++) {
            peer.say(Peer.standing()).seconds(0.1);
        }
        assertEquals(10, peer.sent(P2osCommandNumber.PULSE) - before, 1);
    }

    @Test
    void switchedOffItSaysStopAndGoodbyeAndIsDisconnected() {
        LineBench bench = LineBench.connected(World.bare());
        bench.robot.start(new Instruction.Forward(200), bench.outcomes::add);
        bench.seconds(1);
        bench.robot.setPower(false);
        assertEquals(RobotStatus.DISCONNECTED, bench.robot.status());
        assertEquals(MotionOutcome.Ending.ABORTED, bench.outcomes.get(0).ending());
        byte[] last = bench.sent.get(bench.sent.size() - 1);
        assertArrayEquals(P2osCommand.packet(P2osCommandNumber.CLOSE), last);
        assertFalse(bench.wanted);
        bench.robot.setPower(true);
        assertTrue(bench.wanted);
    }

    // ---- orders ----------------------------------------------------------------------------------------------------

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 20, 99, 500, 9999})
    void aForwardOrderEndsWhereItShould(int centimeters) {
        LineBench bench = LineBench.connected(World.bare());
        MotionOutcome outcome = bench.order(new Instruction.Forward(centimeters));
        assertEquals(new MotionOutcome(MotionOutcome.Ending.DONE, centimeters), outcome);
        assertEquals(centimeters / 100.0, bench.body.xMeters(), 0.0011);
        assertEquals(centimeters / 100.0, bench.robot.pose().xMeters(), 0.0011);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 45, 90, 150, 151, 180, 270, 359, 360})
    void aTurnEndsWhereItShould(int degrees) {
        LineBench bench = LineBench.connected(World.bare());
        MotionOutcome outcome = bench.order(new Instruction.Turn(degrees));
        assertEquals(new MotionOutcome(MotionOutcome.Ending.DONE, degrees), outcome);
        assertEquals(-degrees, Math.toDegrees(bench.body.headingRadians()), 0.1);
        assertEquals((360 - degrees) % 360, bench.robot.pose().headingDegrees() % 360, 0.1);
    }

    @Test
    void manyLegsAddUp() {
        LineBench bench = LineBench.connected(World.bare());
        for (int i = 0; i < 4; i++) {
            bench.order(new Instruction.Forward(100));
            bench.order(new Instruction.Turn(90));
        }
        assertEquals(0, bench.robot.pose().xMeters(), 0.003);
        assertEquals(0, bench.body.xMeters(), 0.003);
        assertEquals(0, bench.body.yMeters(), 0.003);
    }

    @Test
    void contactIsCollisionAndTellsHowFarItCame() {
        LineBench bench = LineBench.connected(WALL_AHEAD);
        bench.statuses.clear();
        MotionOutcome outcome = bench.order(new Instruction.Forward(200));
        assertEquals(MotionOutcome.Ending.COLLISION, outcome.ending());
        assertEquals(75, outcome.amountDone(), 0.2);
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.COLLISION), bench.statuses);
        assertEquals(new Bumpers(0b00100, 0), bench.robot.snapshot().condition().bumpers());
        assertThrows(
                IllegalStateException.class, () -> bench.robot.start(new Instruction.Forward(1), bench.outcomes::add));
    }

    @Test
    void aTurnInCollisionLeadsOutOrEndsInCollisionAgain() {
        LineBench bench = LineBench.connected(WALL_AHEAD);
        bench.order(new Instruction.Forward(200));
        bench.statuses.clear();
        assertEquals(
                MotionOutcome.Ending.COLLISION,
                bench.order(new Instruction.Turn(10)).ending());
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.COLLISION), bench.statuses);
        assertEquals(
                MotionOutcome.Ending.DONE,
                bench.order(new Instruction.Turn(170)).ending());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertEquals(
                MotionOutcome.Ending.DONE,
                bench.order(new Instruction.Forward(20)).ending());
        assertEquals(0.55, bench.body.xMeters(), 0.002);
    }

    @Test
    void aBrakeEndsTheOrderWhenTheRobotStands() {
        LineBench bench = LineBench.connected(World.bare());
        bench.robot.start(new Instruction.Forward(300), bench.outcomes::add);
        bench.seconds(2);
        bench.robot.brake();
        assertEquals(RobotStatus.MOVING, bench.robot.status());
        bench.seconds(3);
        assertEquals(MotionOutcome.Ending.BRAKED, bench.outcomes.get(0).ending());
        assertEquals(bench.body.xMeters() * 100, bench.outcomes.get(0).amountDone(), 0.1);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void anInstructionThatDoesNotGetOnIsAnInfiniteLoop() {
        Peer peer = new Peer().open();
        peer.say(Peer.standing());
        peer.robot.start(new Instruction.Forward(20), peer.outcomes::add);
        for (int i = 0; i < 100 && peer.outcomes.isEmpty(); i++) {
            peer.say(Peer.standing()).seconds(0.1);
        }
        assertEquals(MotionOutcome.Ending.INFINITE_LOOP, peer.outcomes.get(0).ending());
        assertEquals(1, peer.sent(P2osCommandNumber.STOP));
        assertEquals(RobotStatus.STOPPED, peer.robot.status());
    }

    @Test
    void aCommandThatWasLostIsSaidAgain() {
        Peer peer = new Peer().open();
        peer.say(Peer.standing());
        peer.robot.start(new Instruction.Forward(20), peer.outcomes::add);
        for (int i = 0; i < 8; i++) {
            assertEquals(i + 1, peer.sent(P2osCommandNumber.VEL));
            peer.say(Peer.standing()).seconds(0.1);
        }
    }

    // ---- switches and place ----------------------------------------------------------------------------------------

    @Test
    void motorsThatTheRobotSwitchesOffByItselfAreNoMotorsAndAbort() {
        LineBench bench = LineBench.connected(World.bare());
        bench.seconds(1.5);
        bench.robot.start(new Instruction.Forward(200), bench.outcomes::add);
        bench.seconds(1);
        bench.body.setMotors(false);
        bench.seconds(0.3);
        assertEquals(RobotStatus.NO_MOTORS, bench.robot.status());
        assertEquals(MotionOutcome.Ending.ABORTED, bench.outcomes.get(0).ending());
    }

    @Test
    void theMotorsSwitchIsTheRobots() {
        LineBench bench = LineBench.connected(World.bare());
        bench.robot.setMotors(false);
        assertEquals(RobotStatus.NO_MOTORS, bench.robot.status());
        bench.seconds(2);
        assertEquals(RobotStatus.NO_MOTORS, bench.body.status());
        bench.robot.setMotors(true);
        bench.seconds(2);
        assertEquals(RobotStatus.STOPPED, bench.body.status());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void whoMovesItByOtherMeansMakesItMoving() {
        LineBench bench = LineBench.connected(World.bare());
        bench.statuses.clear();
        bench.body.drive().move(0.5);
        bench.seconds(5);
        assertEquals(List.of(RobotStatus.MOVING, RobotStatus.STOPPED), bench.statuses);
        assertEquals(0.5, bench.robot.pose().xMeters(), 0.001);
    }

    @Test
    void placeSaysWhereItStandsAndTheWayGoesOnFromThere() {
        LineBench bench = LineBench.connected(World.bare());
        bench.order(new Instruction.Turn(30));
        assertEquals(Placement.DONE, bench.robot.place(5, 6, Math.PI / 2));
        assertEquals(new Pose(5, 6, 90), bench.robot.pose());
        bench.order(new Instruction.Forward(100));
        assertEquals(5, bench.robot.pose().xMeters(), 0.002);
        assertEquals(7, bench.robot.pose().yMeters(), 0.002);
    }

    @Test
    void sonarsAndBatteryAreTheRobots() {
        LineBench bench = LineBench.connected(WALL_AHEAD);
        assertArrayEquals(bench.body.sonarRangesMillimeters(), bench.robot.sonarRangesMillimeters());
        assertEquals(12.7, bench.robot.snapshot().condition().batteryVolts(), 0.05);
        assertFalse(bench.robot.snapshot().simulated());
    }

    // ---- what else may come ----------------------------------------------------------------------------------------

    @Test
    void noBytesWhateverTakeItDown() {
        Random random = new Random(7);
        for (int i = 0; i < 1000; i++) {
            Peer peer = i % 2 == 0 ? new Peer().open() : new Peer();
            if (i % 2 != 0) {
                peer.robot.connected(peer.nanos);
            }
            byte[] data = new byte[1 + random.nextInt(60)];
            random.nextBytes(data);
            if (random.nextBoolean()) {
                data[0] = (byte) (0x32 + random.nextInt(2));
            }
            peer.say(data);
            byte[] rubbish = new byte[300];
            random.nextBytes(rubbish);
            peer.robot.received(rubbish, peer.nanos);
            peer.seconds(0.2);
        }
        Peer peer = new Peer().open();
        peer.say(Peer.standing());
        assertEquals(RobotStatus.STOPPED, peer.robot.status());
    }

    @Test
    void aTwoDxCountsInItsOwnUnits() {
        Peer peer = new Peer();
        peer.robot.connected(peer.nanos);
        peer.say(new byte[] {0}).say(new byte[] {1}).say("\2anna\0Pioneer\0p2dx\0".getBytes());
        peer.say(Peer.at(32760)).say(Peer.at(32760 + 100 & 0x7FFF));
        assertEquals(0.084, peer.robot.pose().xMeters(), 1e-9);
    }

    /** The far end by hand. */
    private static final class Peer implements PioneerLine {
        private final RealPioneer robot =
                new RealPioneer("robot", this, new Pose(0, 0, 0), true, Optional.empty(), new MapOnly(World.bare()));
        private final java.util.ArrayList<byte[]> said = new java.util.ArrayList<>();
        private final java.util.ArrayList<MotionOutcome> outcomes = new java.util.ArrayList<>();
        private long nanos = 5_000_000_000L;
        private int drops;

        @Override
        public void send(byte[] packet) {
            said.add(packet);
        }

        @Override
        public void call() {}

        @Override
        public void drop() {
            drops++;
        }

        @Override
        public void hangUp() {}

        Peer open() {
            robot.connected(nanos);
            return say(new byte[] {0}).say(new byte[] {1}).say("\2a\0Pioneer\0p3dx\0".getBytes());
        }

        Peer say(byte[] data) {
            robot.received(P2osPacket.of(data), nanos);
            return this;
        }

        Peer seconds(double seconds) {
            for (int i = 0; i < Math.round(seconds * 100); i++) {
                nanos += 10_000_000;
                robot.tick(nanos);
            }
            return this;
        }

        int sent(int command) {
            return (int) said.stream()
                    .filter(packet -> (packet[3] & 0xFF) == command)
                    .count();
        }

        static byte[] standing() {
            return at(0);
        }

        static byte[] at(int x) {
            byte[] sip = new byte[20];
            sip[0] = 0x32;
            sip[1] = (byte) x;
            sip[2] = (byte) (x >> 8);
            sip[16] = 1;
            return sip;
        }
    }
}
