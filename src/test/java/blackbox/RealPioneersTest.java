package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The same orders drive a simulated robot and one at the other end of a P2OS line; the line's far end is ours. */
class RealPioneersTest {
    private enum Kind {
        SIMULATED,
        OVER_P2OS
    }

    /** A robot that can be called, and the body that it moves: itself, or another program's. */
    private record Robot(RunningProgram called, RunningProgram body) {
        static Robot start(Scenario scenario, Kind kind) {
            if (kind == Kind.SIMULATED) {
                RunningProgram robot = scenario.robot("empty.map");
                return new Robot(robot, robot);
            }
            RunningProgram body = scenario.start(
                    "body",
                    "simrobot",
                    "--headless",
                    "--lang=en",
                    "--no-sound",
                    "--world=" + Scenario.world("empty.map"),
                    "--center=127.0.0.1:1",
                    "--p2os=0");
            String port = body.expect("ready").field("p2os");
            RunningProgram robot = scenario.robot("empty.map", "--pioneer", "127.0.0.1:" + port);
            // the console waits, for the status may have come before the registration
            robot.say("wait status value=Stopped 60").ask("pose", "pose");
            return new Robot(robot, body);
        }

        void place(String pose) {
            body.ask("place " + pose, "pose");
            if (called != body) {
                called.ask("place " + pose, "pose");
            }
        }

        /** Where it thinks that it is, and that it is there. */
        ConsoleEvent pose() {
            ConsoleEvent thought = called.ask("pose", "pose");
            ConsoleEvent truth = body.ask("pose", "pose");
            assertEquals(truth.number("x"), thought.number("x"), 0.003);
            assertEquals(truth.number("y"), thought.number("y"), 0.003);
            return thought;
        }
    }

    @ParameterizedTest
    @EnumSource
    void aForwardAndATurnEndWhereTheyShould(Kind kind) throws Exception {
        try (Scenario scenario = new Scenario("20 cm and a quarter turn, " + kind)) {
            scenario.center();
            Robot robot = Robot.start(scenario, kind);
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            ConsoleEvent before = robot.pose();
            scenario.call(phone);
            phone.say("press **#**20**");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
            phone.say("press **#*#90**");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
            ConsoleEvent after = robot.pose();
            assertEquals(0.2, after.number("x") - before.number("x"), 0.003);
            assertEquals(270, after.number("heading"), 0.2);
        }
    }

    @ParameterizedTest
    @EnumSource
    void aWallIsToneFourThenOnlyTurnsArePossibleAndLeadOut(Kind kind) throws Exception {
        try (Scenario scenario = new Scenario("a wall after 5 of 20 cm, " + kind)) {
            scenario.center();
            Robot robot = Robot.start(scenario, kind);
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            robot.place("9.7 0 0");
            scenario.call(phone);
            phone.say("press **#**20**");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "4");
            ConsoleEvent outcome = robot.called().expect("outcome", "tone", "4");
            assertTrue(outcome.field("text").contains("5 of 20 cm"), outcome.toString());
            assertEquals(9.75, robot.pose().number("x"), 0.003);
            phone.say("press **#**20**");
            phone.expectNext("tone", "key", "8");
            phone.say("press **#*#180#**20**");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
            assertEquals(9.55, robot.pose().number("x"), 0.004);
        }
    }

    @ParameterizedTest
    @EnumSource
    void aStopAndAHangUpHoldIt(Kind kind) throws Exception {
        try (Scenario scenario = new Scenario("stop and hang-up, " + kind)) {
            scenario.center();
            Robot robot = Robot.start(scenario, kind);
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press **#**900**");
            phone.expectNext("tone", "key", "6");
            phone.say("press **###**");
            phone.expectNext("tone", "key", "3");
            robot.called().expect("status", "value", "Moving");
            robot.called().expect("status", "value", "Stopped");
            phone.say("press **#**900**");
            phone.expectNext("tone", "key", "6");
            robot.called().expect("status", "value", "Moving");
            phone.say("hangup");
            robot.called().expect("released", "cause", "16");
            robot.called().expect("status", "value", "Stopped");
            assertTrue(robot.pose().number("x") < 8, "it has not gone the whole way");
        }
    }

    @ParameterizedTest
    @EnumSource
    void anOrderBySmsIsAnsweredAndMotorsOffRefuseTheNext(Kind kind) throws Exception {
        try (Scenario scenario = new Scenario("an order by SMS, " + kind)) {
            scenario.center();
            Robot robot = Robot.start(scenario, kind);
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            phone.say("sms " + Scenario.ROBOT + " ** #**10 #*#45 **");
            String reply = phone.expect("sms").field("text");
            assertTrue(reply.startsWith("3 Done: #**10 #*#45. Stopped at"), reply);
            robot.called().say("motors off").expect("status", "value", "No motors");
            phone.say("sms " + Scenario.ROBOT + " ** #**10 **");
            assertEquals("8 Not possible: no motors.", phone.expect("sms").field("text"));
        }
    }

    @Test
    void aLineThatIsLostIsDisconnectedAndComesBackByItself() throws Exception {
        try (Scenario scenario = new Scenario("a real robot is switched off and on")) {
            scenario.center();
            Robot robot = Robot.start(scenario, Kind.OVER_P2OS);
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            robot.body().say("power off");
            robot.called().expect("status", "value", "Disconnected");
            scenario.tell("a caller is denied");
            phone.say("dial " + Scenario.ROBOT);
            phone.expectNext("tone", "key", "2");
            phone.expect("released", "cause", "16");
            robot.body().say("power on");
            robot.called().expect("status", "value", "Stopped");
            scenario.call(phone);
            phone.say("press **#**20**");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
        }
    }

    @ParameterizedTest
    @EnumSource
    void aProcessIsStartedByTelephoneAndGoToReachesItsPlace(Kind kind) throws Exception {
        try (Scenario scenario = new Scenario("processes, " + kind)) {
            scenario.center();
            Robot robot = Robot.start(scenario, kind);
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            robot.place("0 0 0");
            scenario.call(phone);
            phone.say("press **#*1**");
            phone.expectNext("tone", "key", "6");
            robot.called().expect("behaviour", "value", "wander");
            phone.say("press **###**");
            phone.expectNext("tone", "key", "3");
            robot.called().expect("behaviour", "value", "none");
            phone.say("hangup");
            robot.called().expect("released");
            robot.place("0 0 0");
            robot.called().say("goto 1 1");
            ConsoleEvent arrived = robot.called().expect("arrived");
            assertEquals(1, arrived.number("x"), 0.05);
            assertEquals(1, robot.pose().number("y"), 0.05);
        }
    }
}
