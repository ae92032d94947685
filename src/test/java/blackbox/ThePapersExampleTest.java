package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Section 4.1 of the paper: dial the robot, key {@code ** #**20 **}, and it moves 20 cm. */
class ThePapersExampleTest {
    Scenario scenario(String title) {
        return new Scenario(title);
    }

    @Test
    void theRobotMovesTwentyCentimetresAndAnswers() throws Exception {
        try (Scenario scenario = scenario("the paper's example")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            ConsoleEvent before = robot.ask("pose", "pose");

            scenario.tell("the operator dials the number attached to the modem");
            phone.say("dial " + Scenario.ROBOT);
            phone.expect("calling", "number", Scenario.ROBOT);
            phone.expect("alerting");
            robot.expect("call", "from", Scenario.PHONE);
            phone.expect("connected", "number", Scenario.ROBOT);
            phone.expectNext("tone", "key", "1", "meaning", "connection accepted");

            scenario.tell("and keys the order");
            phone.say("press ** #**20 **");
            for (String key : "**#**20**".split("")) {
                robot.expectNext("keys", "keys", key);
            }
            robot.expect("order", "verdict", "accepted");
            phone.expectNext("tone", "key", "6", "meaning", "executing");
            phone.expectNext("tone", "key", "3", "meaning", "executed");

            ConsoleEvent after = robot.expect("pose");
            assertEquals(0.2, after.number("x") - before.number("x"), 0.001);
            assertEquals(0.0, after.number("y") - before.number("y"), 0.001);
            assertEquals(before.number("heading"), after.number("heading"), 0.1);

            scenario.tell("a quarter turn clockwise");
            phone.say("press ** #*#90 **");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
            assertEquals(270.0, robot.expect("pose").number("heading"), 0.1);

            phone.say("hangup");
            phone.expect("released", "cause", "16");
            robot.expect("released", "cause", "16");
            assertEquals(0, phone.quit());
            assertEquals(0, robot.quit());
        }
    }
}
