package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Robots that go their own ways, whoever calls them back, and runs as fast as the machine can. */
class BehaviourTest {
    @Test
    void aWandererIsMovingUntilAnOrderComesWhichIsExecuted() throws Exception {
        try (Scenario scenario = new Scenario("an order to a wanderer")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--speed", "10", "--behaviour", "wander");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            robot.say("status");
            robot.expect("status", "value", "Moving");
            phone.say("sms " + Scenario.ROBOT + " ** #*#45 **");
            robot.expect("behaviour", "value", "none");
            robot.expect("order", "verdict", "accepted");
            robot.expect("outcome", "tone", "3");
            phone.expect("sms", "from", Scenario.ROBOT);
            assertEquals("Stopped", robot.ask("status", "status").field("value"));
            assertEquals("none", robot.ask("behaviour", "behaviour").field("value"));
        }
    }

    @Test
    void aReportByTelephoneDisturbsNoWanderer() throws Exception {
        try (Scenario scenario = new Scenario("a report from a wanderer")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--behaviour", "wander");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press ** #*0 **");
            phone.expect("tone", "key", "6");
            assertEquals("wander", robot.ask("behaviour", "behaviour").field("value"));
            phone.say("press ** ### **");
            phone.expect("tone", "key", "3");
            assertEquals("none", robot.ask("behaviour", "behaviour").field("value"));
        }
    }

    @Test
    void eachOfSeveralRobotsHasItsOwnProcess() throws Exception {
        try (Scenario scenario = new Scenario("two robots, one wanders")) {
            RunningProgram robots = scenario.start(
                    "robots",
                    "simrobot",
                    "--headless",
                    "--no-sound",
                    "--center",
                    "127.0.0.1:1",
                    "--world",
                    Scenario.world("office.map").toString(),
                    "--robot",
                    "a=5550201",
                    "--robot",
                    "b=5550202");
            robots.expect("ready");
            robots.say("@b behaviour wander");
            robots.expect("behaviour", "robot", "b", "value", "wander");
            robots.expect("status", "robot", "b", "value", "Moving");
            robots.say("@a behaviour");
            robots.expect("behaviour", "robot", "a", "value", "none");
            robots.say("@b motors off");
            robots.expect("behaviour", "robot", "b", "value", "none");
            robots.say("@b behaviour wander");
            robots.expect("error");
            robots.say("@b behaviour dance");
            robots.expect("error");
        }
    }

    @Test
    void aRunTellsWhatItSimulatedAndEnds() throws Exception {
        for (String behaviour : new String[] {"wander", "wall-follow", "none"}) {
            FinishedProgram run = FinishedProgram.run(
                    "simrobot",
                    "--headless",
                    "--world",
                    Scenario.world("office.map").toString(),
                    "--robots",
                    "all",
                    "--behaviour",
                    behaviour,
                    "--run",
                    "60");
            assertEquals(0, run.status(), run.error());
            Pattern ran = Pattern.compile("ran robots=[1-9][0-9]* simulated=60.000 cpu=[0-9.]+ wall=[0-9.]+\n");
            assertTrue(ran.matcher(run.output()).matches(), run.output());
        }
    }

    @Test
    void aRunOfNoTimeIsAUsageError() throws Exception {
        FinishedProgram run = FinishedProgram.run("simrobot", "--run", "0");
        assertEquals(2, run.status());
        assertTrue(run.error().contains("--run"), run.error());
        assertNotEquals(
                0,
                FinishedProgram.run("simrobot", "--behaviour", "dance", "--run", "1")
                        .status());
    }

    @Test
    void whatNeedsSomebodyAtTheOtherEndIsRefusedBesideARun() throws Exception {
        for (String option : new String[] {"--p2os=0", "--http=0", "--pioneer=127.0.0.1:8101"}) {
            FinishedProgram refused = FinishedProgram.run("simrobot", "--run", "1", option);
            assertEquals(2, refused.status(), refused.error());
            assertTrue(refused.error().contains(option.substring(0, option.indexOf('='))), refused.error());
        }
    }
}
