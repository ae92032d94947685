package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simrobot.world.World;
import vericommand.ReplyTone;
import vericommand.VeriCommandSettings;
import vericommand.VeriCommandSnapshot;

/** Verifier, simulated robot and console lines together, simulated time moved by hand. */
class RobotControlTest {
    private final ControlBench bench = new ControlBench();

    @Test
    void thePapersExampleMovesTheRobotTwentyCentimetresAndTellsItInOrder() {
        bench.control.callBegan(1, "5550100");
        bench.log.clear();
        bench.press("**#**20**");
        bench.seconds(5);
        assertEquals(
                List.of(
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=#",
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=2",
                        "keys robot=robot keys=0",
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=*",
                        "order robot=robot text=**#**20** verdict=accepted",
                        "modem: under way true",
                        "modem: tone 6",
                        "status robot=robot value=Moving",
                        "status robot=robot value=Stopped",
                        "pose robot=robot x=0.2000 y=0.0000 heading=0.00",
                        "outcome robot=robot tone=3 text=\"Done: #**20. Stopped at 0.200 0.000 m, heading 0.0.\"",
                        "modem: tone 3",
                        "modem: says Done: #**20. Stopped at 0.200 0.000 m, heading 0.0.",
                        "modem: under way false"),
                bench.log);
    }

    @Test
    void aCallThatTheModemEndsForWantOfAKeyTellsTheReasonBeforeItsRelease() {
        bench.control.callBegan(1, "5550100");
        bench.press("**#**20**");
        bench.seconds(5);
        bench.log.clear();
        bench.control.callIdle(60);
        bench.control.callEnded(16);
        assertEquals(
                List.of("call-idle robot=robot seconds=60", "released robot=robot cause=16"),
                bench.lines("call-idle", "released"));
        assertEquals(VeriCommandSnapshot.IDLE, bench.control.snapshot().verdictWord());
    }

    @Test
    void fiftyOrdersMoveFiftyTimesExactly() {
        bench.control.callBegan(1, "5550100");
        for (int i = 0; i < 50; i++) {
            double before = bench.robot.headingRadians();
            bench.press("**#*#90#*#270#**1**");
            bench.seconds(15);
            assertEquals(before - 2 * Math.PI, bench.robot.headingRadians(), 1e-9);
            assertEquals((i + 1) * 0.01, bench.robot.xMeters(), 1e-6);
        }
    }

    @Test
    void everyInstructionOfATripTellsItsPose() {
        bench.control.message("5550101", "** #**20 #*#90 **");
        bench.seconds(10);
        assertEquals(
                List.of(
                        "sms robot=robot from=5550101 text=\"** #**20 #*#90 **\"",
                        "order robot=robot text=**#**20#*#90** verdict=accepted",
                        "status robot=robot value=Moving",
                        "status robot=robot value=Stopped",
                        "pose robot=robot x=0.2000 y=0.0000 heading=0.00",
                        "status robot=robot value=Moving",
                        "status robot=robot value=Stopped",
                        "pose robot=robot x=0.2000 y=0.0000 heading=270.00",
                        "outcome robot=robot tone=3"
                                + " text=\"Done: #**20 #*#90. Stopped at 0.200 0.000 m, heading 270.0.\"",
                        "reply robot=robot to=5550101"
                                + " text=\"3 Done: #**20 #*#90. Stopped at 0.200 0.000 m, heading 270.0.\""),
                bench.lines("sms", "order", "status", "pose", "outcome", "reply"));
    }

    @Test
    void aWallEndsTheOrderInCollisionAndTheTurnLeadsOut() {
        bench.control.callBegan(1, "");
        bench.press("**#**100**");
        bench.seconds(10);
        assertEquals(
                List.of(
                        "status robot=robot value=Moving",
                        "status robot=robot value=Collision",
                        "outcome robot=robot tone=4 text=\"Collision after 75 of 100 cm, instruction 1 of 1.\""),
                bench.lines("status", "outcome"));
        bench.press("**#*#180#**20**");
        bench.seconds(10);
        assertEquals(List.of("modem: tone 6", "modem: tone 3"), bench.lines("modem: tone"));
    }

    @Test
    void motorsSwitchedOnAtTheWallLeadToStoppedAndForwardEndsAfterNoWay() {
        bench.control.message("5550101", "** #**100 **");
        bench.seconds(10);
        bench.robot.setMotors(false);
        bench.robot.setMotors(true);
        bench.log.clear();
        bench.control.message("5550101", "** #**20 **");
        bench.seconds(2);
        assertEquals(
                List.of(
                        "status robot=robot value=Moving",
                        "status robot=robot value=Collision",
                        "reply robot=robot to=5550101 text=\"4 Collision after 0 of 20 cm, instruction 1 of 1.\""),
                bench.lines("status", "reply"));
    }

    @Test
    void aLostCallIsReleasedBeforeTheStatusThatItCauses() {
        bench.control.callBegan(1, "5550100");
        bench.press("**#**70**");
        bench.seconds(1);
        bench.log.clear();
        bench.control.callEnded(41);
        bench.seconds(3);
        assertEquals(
                List.of("released robot=robot cause=41", "status robot=robot value=Stopped"),
                bench.lines("released", "status", "outcome", "modem: tone", "reply"));
        assertTrue(bench.robot.xMeters() < 0.6, "it braked at " + bench.robot.xMeters());
    }

    @Test
    void onHangupFinishLetsTheMotionEnd() {
        ControlBench finishing = new ControlBench(VeriCommandSettings.OnHangup.FINISH);
        finishing.control.callBegan(1, "5550100");
        finishing.press("**#**70#**5**");
        finishing.seconds(1);
        finishing.control.callEnded(16);
        finishing.seconds(10);
        assertEquals(0.7, finishing.robot.xMeters(), 1e-6);
        assertEquals(List.of(), finishing.lines("outcome", "modem: tone 3"));
    }

    @Test
    void stopBrakesWithTheRobotsDecelerationAndIsAnsweredWhenItStands() {
        bench.control.callBegan(1, "5550100");
        bench.press("**#**70**");
        bench.seconds(1);
        bench.log.clear();
        bench.press("**###**");
        assertEquals(List.of(), bench.lines("status", "modem: tone"), "it still rolls");
        bench.seconds(3);
        assertEquals(
                List.of("status robot=robot value=Stopped", "modem: tone 3"), bench.lines("status", "modem: tone"));
    }

    @Test
    void motorsOffAbortAtOnce() {
        bench.control.callBegan(1, "5550100");
        bench.press("**#**70**");
        bench.seconds(1);
        bench.log.clear();
        double x = bench.robot.xMeters();
        bench.robot.setMotors(false);
        bench.seconds(1);
        assertEquals(x, bench.robot.xMeters());
        assertEquals(
                List.of("status robot=robot value=\"No motors\"", "modem: tone 8"),
                bench.lines("status", "modem: tone"));
    }

    @Test
    void theFirstToneGoesByTheNewestStatus() {
        assertEquals(ReplyTone.CONNECTION_ACCEPTED, bench.control.admission("5550100"));
        bench.robot.setPower(false);
        assertEquals(ReplyTone.CONNECTION_DENIED, bench.control.admission("5550100"));
        bench.robot.setPower(true);
        assertEquals(ReplyTone.CONNECTION_ACCEPTED, bench.control.admission("5550100"));
    }

    @Test
    void anOrderUnderWayBySmsIsReportedToTheModemOfACallThatBegins() {
        bench.control.message("5550101", "** #**70 **");
        bench.log.clear();
        bench.control.callBegan(1, "5550100");
        assertEquals(List.of("modem: under way true"), bench.lines("modem:"));
    }

    @Test
    void aWorldThatChangesUnderAMovingRobotEndsItsOrderAndSaysSo() {
        bench.control.message("5550101", "** #**70 **");
        bench.seconds(1);
        bench.simulation.load(World.bare());
        assertEquals(
                List.of(
                        "outcome robot=robot tone=8"
                                + " text=\"Not possible: the world has changed. Ended after 15 of 70 cm, instruction 1 of 1.\""),
                bench.lines("outcome"));
    }

    @Test
    void aSenderThatIsNoNumberGetsNoReply() {
        bench.control.message("nobody", "hello");
        assertEquals(List.of(), bench.lines("reply"));
    }

    @Test
    void theSnapshotFollowsEveryKeyAndTheEndOfTheOrder() {
        bench.control.callBegan(1, "5550100");
        bench.press("**#**20**");
        assertEquals("**#**20**", bench.control.snapshot().keys());
        assertTrue(bench.control.snapshot().underWay());
        bench.seconds(5);
        assertFalse(bench.control.snapshot().underWay());
        assertEquals(1, bench.control.snapshot().replies().size());
    }

    @Test
    void aLowBatteryIsToldOnceAndInEachReply() {
        bench.robot.battery().setVolts(10.9);
        bench.control.message("5550101", "** #**20 **");
        bench.seconds(5);
        List<String> low = bench.lines("battery", "outcome");
        assertEquals("battery robot=robot state=low", low.get(0));
        assertTrue(low.get(1).endsWith("heading 0.0. Battery low.\""), low.toString());
        assertEquals(2, low.size());
        bench.robot.battery().setVolts(12);
        bench.control.message("5550101", "** #**20 **");
        bench.seconds(5);
        List<String> charged = bench.lines("battery", "outcome");
        assertEquals("battery robot=robot state=ok", charged.get(0));
        assertTrue(charged.get(1).endsWith("heading 0.0.\""), charged.toString());
    }
}
