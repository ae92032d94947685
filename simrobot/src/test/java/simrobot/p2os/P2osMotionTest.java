package simrobot.p2os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.robot.Placement;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;

/** What a client makes the robot do, and what the robot then tells of it. */
class P2osMotionTest {
    // ---- motion ----------------------------------------------------------------------------------------------------

    @ParameterizedTest
    @ValueSource(ints = {500, -300, -400, -197, 1, 749})
    void moveIsExactAheadAndBack(int millimeters) {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.MOVE, millimeters).seconds(8);
        assertEquals(millimeters / 1000.0, bench.robot.xMeters(), 1e-9);
        assertEquals(InformationPacket.STOPPED_ID, bench.sip().id());
        int units = bench.sip().x();
        assertEquals(millimeters, (units >= 0x4000 ? units - 0x8000 : units) * 0.485, 0.25);
    }

    @Test
    void moveTakesNoLongerThanItsProfile() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.MOVE, 500).seconds(2.6);
        assertEquals(InformationPacket.STOPPED_ID, bench.sip().id());
    }

    @ParameterizedTest
    @CsvSource({"90, 90", "-90, -90", "1, 1", "180, 180", "270, 270", "-360, -360"})
    void relativeTurnsAreExact(int degrees, double expected) {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.DHEAD, degrees).seconds(8);
        assertEquals(expected, Math.toDegrees(bench.robot.headingRadians()), 1e-7);
    }

    @ParameterizedTest
    @CsvSource({"90, 90", "-90, -90", "270, -90", "350, -10", "-170, -170", "0, 0", "720, 0"})
    void absoluteHeadingsAreExactAndTakeTheShortWay(int degrees, double expected) {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.HEAD, degrees).seconds(8);
        assertEquals(expected, Math.toDegrees(bench.robot.headingRadians()), 1e-7);
    }

    @Test
    void theTargetHeadingIsReportedAndTurnsFromItAddUp() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.HEAD, 30).say(P2osCommandNumber.DCHEAD, 15).seconds(0.1);
        assertEquals(512, bench.sip().target());
        bench.seconds(5);
        assertEquals(45, bench.sip().headingDegrees(), 0.05);
    }

    @Test
    void velocityIsReachedWithTheSetAccelerationAndReported() {
        SessionBench bench = SessionBench.openedOnBareFloor();
        bench.say(P2osCommandNumber.SETA, 100).say(P2osCommandNumber.VEL, 200).seconds(1);
        assertEquals(0.1, bench.robot.speedMetersPerSecond(), 1e-9);
        bench.seconds(2);
        assertEquals(200, bench.sip().left());
        assertEquals(200, bench.sip().right());
        assertEquals(InformationPacket.MOVING_ID, bench.sip().id());
        bench.say(P2osCommandNumber.SETA, -400).say(P2osCommandNumber.STOP).seconds(0.25);
        assertEquals(0.1, bench.robot.speedMetersPerSecond(), 1e-9);
        bench.seconds(1);
        assertEquals(InformationPacket.STOPPED_ID, bench.sip().id());
    }

    @Test
    void topSpeedsHold() {
        SessionBench bench = SessionBench.openedOnBareFloor();
        bench.say(P2osCommandNumber.SETV, 150).say(P2osCommandNumber.VEL, -400).seconds(3);
        assertEquals(-150, bench.sip().left());
        bench.say(P2osCommandNumber.SETV, 30000)
                .say(P2osCommandNumber.SETA, 30000)
                .say(P2osCommandNumber.VEL, 30000);
        bench.seconds(1);
        assertEquals(2200, bench.sip().left());
        bench.say(P2osCommandNumber.STOP)
                .say(P2osCommandNumber.SETRV, 20)
                .say(P2osCommandNumber.RVEL, 90)
                .seconds(9);
        assertEquals(200, bench.sip().turn());
    }

    @Test
    void turningIsReportedByTheWheelsToo() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.RVEL, 30).seconds(2);
        Sip sip = bench.sip();
        assertEquals(300, sip.turn());
        // what ARIA computes: half the difference times 0.0056 radians
        assertEquals(Math.toRadians(30), (sip.right() - sip.left()) / 2.0 * 0.0056, 0.006);
        assertEquals(InformationPacket.MOVING_ID, sip.id());
    }

    @Test
    void twoWheelsMakeAnArc() {
        SessionBench bench = SessionBench.openedOnBareFloor();
        bench.say(P2osCommandNumber.SETA, 30000).say(P2osCommandNumber.SETRA, 30000);
        bench.say(P2osCommandNumber.VEL2, 5 << 8 | 10).seconds(1);
        assertEquals(100, bench.sip().left());
        assertEquals(200, bench.sip().right());
        assertTrue(bench.robot.headingRadians() > 0);
    }

    @Test
    void theEmergencyStopTakesNoWay() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.VEL, 300).seconds(1.5);
        double x = bench.robot.xMeters();
        bench.say(P2osCommandNumber.E_STOP).seconds(1);
        assertEquals(x, bench.robot.xMeters());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
    }

    @Test
    void setOriginSetsTheOdometryToZeroAndNotTheRobot() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.MOVE, 300)
                .seconds(4)
                .say(P2osCommandNumber.DHEAD, 45)
                .seconds(4);
        bench.say(P2osCommandNumber.SETO).seconds(0.1);
        assertEquals(0, bench.sip().x());
        assertEquals(0, bench.sip().heading());
        assertEquals(0.3, bench.robot.xMeters(), 1e-9);
    }

    // ---- traps -----------------------------------------------------------------------------------------------------

    @Test
    void draggingTheRobotDoesNotTouchTheOdometry() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.MOVE, 200).seconds(3);
        assertEquals(Placement.DONE, bench.robot.place(-1, 2, 1));
        bench.seconds(0.1);
        assertEquals(200, bench.sip().xMillimeters(), 0.25);
        assertEquals(0, bench.sip().heading());
    }

    @Test
    void placesHaveFifteenBitsAndRollOverInSmallSteps() {
        SessionBench bench = SessionBench.openedOnBareFloor();
        bench.say(P2osCommandNumber.SETV, 2200)
                .say(P2osCommandNumber.MOVE, 20000)
                .seconds(30);
        int before = 0;
        int total = 0;
        for (Sip sip : bench.sips()) {
            assertTrue(sip.x() <= 0x7FFF);
            int step = sip.x() - before & 0x7FFF;
            assertTrue(step < 0x1000, "step " + step);
            total += step;
            before = sip.x();
        }
        assertEquals(20000, total * 0.485, 0.3);
    }

    // ---- contact ---------------------------------------------------------------------------------------------------

    @Test
    void contactIsCollisionAStallAndAFrontBumper() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.VEL, 300).seconds(5);
        assertEquals(RobotStatus.COLLISION, bench.robot.status());
        assertEquals(0.75, bench.robot.xMeters(), 1e-6);
        assertTrue(bench.sip().stalled());
        assertEquals(1 << 3, bench.sip().rightByte() & 0x3E, "the middle bumper in front");
        assertEquals(0, bench.sip().leftByte() & 0x3E);
        assertEquals(0, bench.sip().left());
    }

    @Test
    void contactBehindPressesARearBumper() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.MOVE, -2500).seconds(10);
        assertEquals(RobotStatus.COLLISION, bench.robot.status());
        assertEquals(-1.75, bench.robot.xMeters(), 1e-6);
        assertTrue(bench.sip().stalled());
        assertEquals(1 << 3, bench.sip().leftByte() & 0x3E);
        assertEquals(0, bench.sip().rightByte() & 0x3E);
    }

    @Test
    void theClientBacksAwayFromCollisionAndTheFlagsClear() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.VEL, 300).seconds(5);
        bench.say(P2osCommandNumber.MOVE, -200).seconds(5);
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertEquals(0.55, bench.robot.xMeters(), 1e-6);
        assertFalse(bench.sip().stalled());
        assertEquals(0, bench.sip().rightByte());
    }

    @Test
    void aBumperMovesRoundWithTheTurn() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.VEL, 300).seconds(5);
        bench.say(P2osCommandNumber.DHEAD, 72).seconds(4);
        assertEquals(1 << 5, bench.sip().rightByte() & 0x3E, "the rightmost in front");
        bench.say(P2osCommandNumber.DHEAD, 72).seconds(4);
        assertEquals(1 << 2, bench.sip().leftByte() & 0x3E, "behind on the right");
    }

    @Test
    void withoutBumpStallTheWheelsNoticeAfterHalfASecond() {
        SessionBench bench = SessionBench.opened();
        bench.say(P2osCommandNumber.BUMPSTALL, 2).say(P2osCommandNumber.VEL, 300);
        for (int i = 0; i < 1000 && bench.robot.status() != RobotStatus.COLLISION; i++) {
            bench.seconds(0.01);
        }
        bench.seconds(0.3);
        assertFalse(bench.sip().stalled());
        assertEquals(1 << 3, bench.sip().rightByte());
        bench.seconds(0.4);
        assertTrue(bench.sip().stalled());
    }

    // ---- watchdog --------------------------------------------------------------------------------------------------

    @Test
    void aSilentClientsRobotStopsAfterTwoSecondsAndGoesOnAtTheNextPacket() {
        SessionBench bench = SessionBench.openedOnBareFloor();
        bench.say(P2osCommandNumber.VEL, 150).fallSilent().seconds(1.99);
        assertEquals(0.15, bench.robot.speedMetersPerSecond(), 1e-9);
        bench.seconds(0.8);
        assertEquals(0, bench.robot.speedMetersPerSecond());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertEquals(InformationPacket.STOPPED_ID, bench.sip().id());
        bench.seconds(3).say(P2osCommandNumber.PULSE).seconds(1);
        assertEquals(0.15, bench.robot.speedMetersPerSecond(), 1e-9);
        assertEquals(InformationPacket.MOVING_ID, bench.sip().id());
    }

    @Test
    void aMoveThatTheWatchdogBrokeOffEndsExactly() {
        SessionBench bench = SessionBench.openedOnBareFloor();
        bench.say(P2osCommandNumber.MOVE, 3000).fallSilent().seconds(5);
        assertTrue(bench.robot.xMeters() < 2.5);
        bench.say(P2osCommandNumber.PULSE).fallSilent();
        for (int i = 0; i < 10; i++) {
            bench.say(P2osCommandNumber.PULSE).seconds(1);
        }
        assertEquals(3, bench.robot.xMeters(), 1e-9);
    }

    @Test
    void anInvalidPacketIsNoSignOfLife() {
        SessionBench bench = SessionBench.openedOnBareFloor();
        bench.say(P2osCommandNumber.VEL, 150).fallSilent();
        for (int i = 0; i < 6; i++) {
            bench.say(new byte[] {(byte) 0xFA, (byte) 0xFB, 3, 0, 0, 1}).seconds(0.5);
        }
        assertEquals(0, bench.robot.speedMetersPerSecond());
    }

    // ---- with the telephone ----------------------------------------------------------------------------------------

    @Test
    void anOrderByTelephoneIsReportedAsMotionAndCannotBeTurnedAside() {
        SessionBench bench = SessionBench.opened();
        List<MotionOutcome> outcomes = new ArrayList<>();
        bench.robot.start(new Instruction.Forward(50), outcomes::add);
        bench.seconds(1);
        assertEquals(InformationPacket.MOVING_ID, bench.sip().id());
        bench.say(P2osCommandNumber.VEL, -300)
                .say(P2osCommandNumber.DHEAD, 90)
                .say(P2osCommandNumber.SETV, 100)
                .seconds(5);
        assertEquals(MotionOutcome.Ending.DONE, outcomes.get(0).ending());
        assertEquals(0.5, bench.robot.xMeters(), 1e-9);
        assertEquals(0, bench.robot.headingRadians());
    }

    @Test
    void stopHoldsAnOrderByTelephoneToo() {
        SessionBench bench = SessionBench.opened();
        List<MotionOutcome> outcomes = new ArrayList<>();
        bench.robot.start(new Instruction.Forward(70), outcomes::add);
        bench.seconds(1).say(P2osCommandNumber.STOP).seconds(3);
        assertEquals(MotionOutcome.Ending.BRAKED, outcomes.get(0).ending());
    }

    @Test
    void theWatchdogAndALostClientLeaveAnOrderByTelephoneAlone() {
        SessionBench bench = SessionBench.openedOnBareFloor();
        List<MotionOutcome> outcomes = new ArrayList<>();
        bench.robot.start(new Instruction.Forward(300), outcomes::add);
        bench.fallSilent().seconds(3);
        bench.session.lost();
        bench.seconds(10);
        assertEquals(MotionOutcome.Ending.DONE, outcomes.get(0).ending());
    }
}
