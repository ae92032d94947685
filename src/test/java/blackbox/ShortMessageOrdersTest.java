package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Orders by SMS: the same language, one reply each, faults named with their position. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ShortMessageOrdersTest {
    Scenario scenario(String title) {
        return new Scenario(title);
    }

    private Scenario scenario;
    private RunningProgram robot;
    private RunningProgram phone;

    @BeforeAll
    void oneRobotOnePhone() {
        scenario = scenario("orders by SMS");
        scenario.center();
        robot = scenario.robot("empty.map", "--speed", "20");
        phone = scenario.phone(Scenario.PHONE);
    }

    @AfterAll
    void end() throws Exception {
        scenario.close();
    }

    private String reply(String text) {
        phone.say("sms " + Scenario.ROBOT + " " + text);
        return phone.expect("sms", "from", Scenario.ROBOT).field("text");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "** #** **|number expected at key 6|",
                "** #**0 **|number expected at key 7|1..9999",
                "** #**0000 **|number expected at key 10|1..9999",
                "** #*#0 **|number expected at key 7|1..360",
                "** #*#361 **|number expected at key 9|1..360",
                "** #**12345 **|at key 10|",
                "** 20 **|at key 3|",
                "hello|at key 1|",
                "1** #**20 **|at key 1|",
                "** #a*20 **|at key 4|",
                "** #**20 ** x|at key 10|",
                "** #**20 ** ** #**20 **|at key 10|",
                "** #**20|at key 8|",
                "** #**20 *|at key 9|",
                "**|at key 3|",
                "** **|at key 5|",
                "*|at key 2|",
                "** #*5 **|at key 5|",
                "** ##* **|at key 5|",
                "** #**2A **|at key 7|"
            })
    void anInvalidMessageIsAnsweredWithThePositionOfItsFault(String text, String fault, String range) {
        String reply = reply(text);
        assertTrue(reply.startsWith("7 Not a valid command: "), reply);
        assertTrue(reply.contains(fault), reply);
        assertTrue(range == null || reply.contains(range), reply);
        robot.expect("order", "verdict", "invalid");
        assertTrue(reply.length() <= 160, reply);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "** #**1 **",
                "** #**0020 **",
                "**#*#360**",
                "*** #**20 **",
                "* * # * * 2 0 * *",
                "\"** #**20\\n**\""
            })
    void blanksLineBreaksLeadingZerosAndFurtherStarsAreAllowed(String text) {
        robot.ask("place 0 0 0", "pose");
        String reply = reply(text);
        assertTrue(reply.startsWith("3 Done"), reply);
    }

    @Test
    void aWholeTripFitsInOneMessage() {
        robot.ask("place 0 0 0", "pose");
        String reply = reply("** #**100 #*#90 #**100 **");
        assertTrue(reply.startsWith("3 Done"), reply);
        ConsoleEvent pose = robot.ask("pose", "pose");
        assertEquals(1.0, pose.number("x"), 0.001);
        assertEquals(-1.0, pose.number("y"), 0.001);
        assertEquals(270.0, pose.number("heading"), 0.1);
    }

    @Test
    void thirtyTwoInstructionsAreTakenAndThirtyThreeAreNot() {
        robot.ask("place 0 0 0", "pose");
        assertTrue(reply("**" + "#*#1".repeat(32) + "**").startsWith("3 Done"));
        String refused = reply("**" + "#*#1".repeat(33) + "**");
        assertTrue(refused.startsWith("7 "), refused);
        assertTrue(refused.contains("at key " + (2 + 32 * 4 + 1)), refused);
    }

    @Test
    void aTripThatMeetsAWallSaysHowFarItGot() {
        robot.ask("place 9 0 0", "pose");
        String reply = reply("** #*#360 #**100 #*#90 **");
        assertEquals("4 Collision after 75 of 100 cm, instruction 2 of 3.", reply);
        robot.ask("place 0 0 0", "pose");
    }
}
