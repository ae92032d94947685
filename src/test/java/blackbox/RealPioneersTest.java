package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.EnumMap;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The same orders drive a simulated robot and one at the other end of a P2OS line; the line's far end is ours. A session of
 * each kind serves all tests.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@TestMethodOrder(MethodOrderer.MethodName.class)
class RealPioneersTest {
    private enum Kind {
        SIMULATED,
        OVER_P2OS
    }

    /** A robot that can be called, and the body that it moves: itself, or another program's. */
    private record Robot(Scenario scenario, RunningProgram phone, RunningProgram called, RunningProgram body) {
        static Robot start(Kind kind) {
            Scenario scenario = new Scenario("orders, " + kind);
            scenario.center();
            if (kind == Kind.SIMULATED) {
                RunningProgram robot = scenario.robot("empty.map");
                return new Robot(scenario, scenario.phone(Scenario.PHONE), robot, robot);
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
            return new Robot(scenario, scenario.phone(Scenario.PHONE), robot, body);
        }

        void call() {
            scenario.call(phone);
        }

        void hangUp() {
            phone.say("hangup");
            called.expect("released", "cause", "16");
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

    private final Map<Kind, Robot> robots = new EnumMap<>(Kind.class);

    /** At the origin, stopped, without a call. */
    private Robot robot(Kind kind) {
        Robot robot = robots.computeIfAbsent(kind, Robot::start);
        robot.phone().ask("inbox", "end");
        robot.place("0 0 0");
        return robot;
    }

    @AfterAll
    void end() throws IOException {
        for (Robot robot : robots.values()) {
            robot.scenario().close();
        }
    }

    @ParameterizedTest
    @EnumSource
    void aForwardAndATurnEndWhereTheyShould(Kind kind) throws Exception {
        Robot robot = robot(kind);
        RunningProgram phone = robot.phone();
        ConsoleEvent before = robot.pose();
        robot.call();
        phone.say("press **#**20**");
        phone.expectNext("tone", "key", "6");
        phone.expectNext("tone", "key", "3");
        phone.say("press **#*#90**");
        phone.expectNext("tone", "key", "6");
        phone.expectNext("tone", "key", "3");
        ConsoleEvent after = robot.pose();
        assertEquals(0.2, after.number("x") - before.number("x"), 0.003);
        assertEquals(270, after.number("heading"), 0.2);
        robot.hangUp();
    }

    @ParameterizedTest
    @EnumSource
    void aWallIsToneFourThenOnlyTurnsArePossibleAndLeadOut(Kind kind) throws Exception {
        Robot robot = robot(kind);
        RunningProgram phone = robot.phone();
        robot.place("9.7 0 0");
        robot.call();
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
        robot.hangUp();
    }

    @ParameterizedTest
    @EnumSource
    void aStopAndAHangUpHoldIt(Kind kind) throws Exception {
        Robot robot = robot(kind);
        RunningProgram phone = robot.phone();
        robot.call();
        phone.say("press **#**900**");
        phone.expectNext("tone", "key", "6");
        phone.say("press **###**");
        phone.expectNext("tone", "key", "3");
        robot.called().expect("status", "value", "Moving");
        robot.called().expect("status", "value", "Stopped");
        phone.say("press **#**900**");
        phone.expectNext("tone", "key", "6");
        robot.called().expect("status", "value", "Moving");
        robot.hangUp();
        robot.called().expect("status", "value", "Stopped");
        assertTrue(robot.pose().number("x") < 8, "it has not gone the whole way");
    }

    @ParameterizedTest
    @EnumSource
    void anOrderBySmsIsAnsweredAndMotorsOffRefuseTheNext(Kind kind) throws Exception {
        Robot robot = robot(kind);
        RunningProgram phone = robot.phone();
        phone.say("sms " + Scenario.ROBOT + " ** #**10 #*#45 **");
        String reply = phone.expect("sms").field("text");
        assertTrue(reply.startsWith("3 Done: #**10 #*#45. Stopped at"), reply);
        robot.called().say("motors off").expect("status", "value", "No motors");
        phone.say("sms " + Scenario.ROBOT + " ** #**10 **");
        assertEquals("8 Not possible: no motors.", phone.expect("sms").field("text"));
        robot.called().say("motors on").expect("status", "value", "Stopped");
    }

    @Test
    void aLineThatIsLostIsDisconnectedAndComesBackByItself() throws Exception {
        Robot robot = robot(Kind.OVER_P2OS);
        RunningProgram phone = robot.phone();
        robot.body().say("power off");
        robot.called().expect("status", "value", "Disconnected");
        robot.scenario().tell("a caller is denied");
        phone.say("dial " + Scenario.ROBOT);
        phone.expectNext("tone", "key", "2");
        phone.expect("released", "cause", "16");
        robot.body().say("power on");
        robot.called().expect("status", "value", "Stopped");
        robot.call();
        phone.say("press **#**20**");
        phone.expectNext("tone", "key", "6");
        phone.expectNext("tone", "key", "3");
        robot.hangUp();
    }

    @ParameterizedTest
    @EnumSource
    void aProcessIsStartedByTelephoneAndGoToReachesItsPlace(Kind kind) throws Exception {
        Robot robot = robot(kind);
        RunningProgram phone = robot.phone();
        robot.call();
        phone.say("press **#*1**");
        phone.expectNext("tone", "key", "6");
        robot.called().expect("behaviour", "value", "wander");
        phone.say("press **###**");
        phone.expectNext("tone", "key", "3");
        robot.called().expect("behaviour", "value", "none");
        robot.hangUp();
        robot.place("0 0 0");
        robot.called().say("goto 1 1");
        ConsoleEvent arrived = robot.called().expect("arrived");
        assertEquals(1, arrived.number("x"), 0.05);
        assertEquals(1, robot.pose().number("y"), 0.05);
    }
}
