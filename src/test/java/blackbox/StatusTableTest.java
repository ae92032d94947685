package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** Every row of the status table, by SMS and by tones: which order is taken, which is refused, and with which tone. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class StatusTableTest {
    private Scenario scenario;
    private RunningProgram robot;
    private RunningProgram phone;

    @BeforeAll
    void aRobotTwentyCentimetresFromAWall() throws Exception {
        scenario = new Scenario("the status table");
        scenario.center();
        robot = scenario.robot("empty.map", "--speed", "4");
        phone = scenario.phone(Scenario.PHONE);
    }

    @AfterAll
    void end() throws Exception {
        scenario.close();
    }

    @BeforeEach
    void theRobotIsStoppedInTheMiddle() {
        robot.say("power on").expect("status");
        robot.say("motors on").expect("status");
        robot.ask("place 0 0 0", "pose");
        assertEquals("Stopped", robot.ask("status", "status").field("value"));
    }

    /** Sends an order by SMS and returns the first reply to it. */
    private String reply(String order) {
        phone.say("sms " + Scenario.ROBOT + " " + order);
        return phone.expect("sms", "from", Scenario.ROBOT).field("text");
    }

    /** Drives the robot against the east wall of the 20 m hall. */
    private void collide() {
        robot.ask("place 9.5 0 0", "pose");
        assertEquals("4 Collision after 25 of 100 cm, instruction 1 of 1.", reply("** #**100 **"));
        assertEquals("Collision", robot.ask("status", "status").field("value"));
    }

    private void assertStatus(String expected) {
        assertEquals(expected, robot.ask("status", "status").field("value"));
    }

    @Test
    void stoppedExecutesForwardAndTurn() {
        assertTrue(reply("** #**20 **").startsWith("3 Done: #**20. Stopped at 0.200 0.000 m, heading 0.0."));
        assertTrue(reply("** #*#90 **").startsWith("3 Done: #*#90. Stopped at 0.200 0.000 m, heading 270.0."));
        assertStatus("Stopped");
    }

    @Test
    void stoppedTakesStopAndReport() {
        assertTrue(reply("** ### **").startsWith("3 "));
        assertTrue(reply("** #*0 **").startsWith("3 "));
    }

    @Test
    void collisionRefusesForward() {
        collide();
        String refused = reply("** #**20 **");
        assertTrue(refused.startsWith("8 "), refused);
        assertStatus("Collision");
    }

    @Test
    void collisionExecutesATurnAndTheWayOutIsATurnThenForward() {
        collide();
        String out = reply("** #*#90 #**20 **");
        assertTrue(out.startsWith("3 Done"), out);
        assertStatus("Stopped");
    }

    @Test
    void aTurnInCollisionThatLeavesTheWayBlockedEndsTheOrderInCollision() {
        collide();
        String blocked = reply("** #*#10 #**20 **");
        assertTrue(blocked.startsWith("4 "), blocked);
        assertStatus("Collision");
    }

    @Test
    void collisionTakesStopAndReport() {
        collide();
        assertTrue(reply("** ### **").startsWith("3 "));
        assertTrue(reply("** #*0 **").startsWith("4 "));
    }

    @Test
    void noMotorsRefusesForwardTurnAndStopButReports() {
        robot.say("motors off").expect("status", "value", "No motors");
        assertEquals("8 Not possible: no motors.", reply("** #**20 **"));
        assertEquals("8 Not possible: no motors.", reply("** #*#90 **"));
        assertTrue(reply("** ### **").startsWith("8 "));
        assertTrue(reply("** #*0 **").startsWith("8 "));
        assertStatus("No motors");
    }

    @Test
    void disconnectedDeniesTheConnection() {
        robot.say("power off").expect("status", "value", "Disconnected");
        assertEquals("2 Connection denied: the robot is off.", reply("** #**20 **"));
        phone.say("dial " + Scenario.ROBOT);
        phone.expect("connected");
        phone.expectNext("tone", "key", "2", "meaning", "connection denied");
        phone.expect("released", "cause", "16");
    }

    @Test
    void movingAnswersSixToAnyFurtherOrderThatMoves() {
        phone.say("sms " + Scenario.ROBOT + " ** #**900 **");
        robot.expect("status", "value", "Moving");
        assertEquals("6 Executing a command.", reply("** #**20 **"));
        assertEquals("6 Executing a command.", reply("** #*#20 ### **"));
        assertTrue(reply("** #*0 **").startsWith("6 "));
        phone.say("sms " + Scenario.ROBOT + " ** ### **");
        robot.expect("status", "value", "Stopped");
        String first = phone.expect("sms", "from", Scenario.ROBOT).field("text");
        String second = phone.expect("sms", "from", Scenario.ROBOT).field("text");
        Set<Character> tones = Set.of(first.charAt(0), second.charAt(0));
        assertEquals(Set.of('8', '3'), tones, first + " / " + second);
        String stopped = first.startsWith("8") ? first : second;
        assertTrue(stopped.matches("8 Stopped by order after [0-9]+ of 900 cm.*"), stopped);
    }

    @Test
    void motorsOffAbortsWhatIsUnderWayAndTheRobotStandsAtOnce() {
        phone.say("sms " + Scenario.ROBOT + " ** #**900 **");
        robot.expect("status", "value", "Moving");
        robot.say("motors off").expect("status", "value", "No motors");
        ConsoleEvent there = robot.ask("pose", "pose");
        String aborted = phone.expect("sms", "from", Scenario.ROBOT).field("text");
        assertTrue(aborted.startsWith("8 "), aborted);
        assertEquals(there.field("x"), robot.ask("pose", "pose").field("x"));
    }
}
