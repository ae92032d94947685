package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Robots with processes, orders that end them, and runs at the machine's speed. */
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
            assertEquals(
                    List.of("Moving"),
                    robot.allSaid("status").stream()
                            .map(event -> event.field("value"))
                            .toList());
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
    void aRunWritesTheTracksOfItsRobots(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("track.csv");
        FinishedProgram run = FinishedProgram.run(
                "simrobot",
                "--world=" + Scenario.world("office.map"),
                "--robot=a=5550201",
                "--robot=b=5550202",
                "--behaviour=wander",
                "--seed=3",
                "--run=2",
                "--track=" + file);
        assertEquals(1, run.status(), "a wanderer is never done");
        List<String> lines = Files.readAllLines(file);
        assertEquals("robot,time,x,y,heading,status", lines.get(0));
        assertEquals(1 + 2 * 21, lines.size(), "from 0.0 to 2.0 s");
        assertTrue(lines.get(1).startsWith("a,0.00,"), lines.get(1));
        assertTrue(lines.get(2).startsWith("b,0.00,"), lines.get(2));
        assertTrue(
                lines.get(42).matches("b,2\\.00,-?[0-9]+\\.[0-9]{4},-?[0-9]+\\.[0-9]{4},[0-9]+\\.[0-9]{2},Moving"),
                lines.get(42));
    }

    @Test
    void aBatchOfRunsPrintsALineForEachSeedAndRepeats() throws Exception {
        String[] options = {
            "--world=" + Scenario.world("office.map"),
            "--behaviour=wander",
            "--noise=1",
            "--seed=7",
            "--run=30",
            "--runs=3"
        };
        FinishedProgram runs = FinishedProgram.run("simrobot", options);
        assertEquals(1, runs.status(), runs.error());
        List<String> lines = runs.output().lines().toList();
        assertEquals("seed,state,robots,done,seconds,meters,collisions,text", lines.get(0));
        assertEquals(4, lines.size(), runs.output());
        for (int run = 0; run < 3; run++) {
            assertTrue(lines.get(run + 1).startsWith((7 + run) + ",timeout,1,0,30.000,"), lines.get(run + 1));
        }
        assertNotEquals(lines.get(1).substring(2), lines.get(2).substring(2));
        assertEquals(runs.output(), FinishedProgram.run("simrobot", options).output());
    }

    @Test
    void tracksAndRunsBelongToARun() throws Exception {
        for (String[] options : new String[][] {
            {"--headless", "--track=x.csv"}, {"--headless", "--runs=2"}, {"--run=1", "--runs=2", "--track=x.csv"}
        }) {
            FinishedProgram refused = FinishedProgram.run("simrobot", options);
            assertEquals(2, refused.status(), refused.error());
        }
        assertEquals(
                74,
                FinishedProgram.run("simrobot", "--run=1", "--track=/nowhere/x.csv")
                        .status());
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
            assertEquals(1, run.status(), run.error());
            Pattern ran = Pattern.compile("ran robots=8 simulated=60.000 cpu=[0-9.]+ wall=[0-9.]+\n"
                    + "(outcome robot=[^ ]+ name=" + behaviour
                    + " state=timeout seconds=60.000 meters=[0-9.]+ text=\"not done\"\n){8}");
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
    void optionsThatNeedAPeerAreRefusedBesideARun() throws Exception {
        for (String option : new String[] {"--p2os=0", "--http=0", "--pioneer=127.0.0.1:8101"}) {
            FinishedProgram refused = FinishedProgram.run("simrobot", "--run", "1", option);
            assertEquals(2, refused.status(), refused.error());
            assertTrue(refused.error().contains(option.substring(0, option.indexOf('='))), refused.error());
        }
    }

    @Test
    void keysOfACallDriveAProcessAndAnotherReportsBySms() throws Exception {
        try (Scenario scenario = new Scenario("the phone as a joystick, and a guard")) {
            Path mine = Files.createDirectory(scenario.folder().resolve("mine"));
            for (String example : List.of("Guard.java", "Joystick.java")) {
                Files.copy(Dist.root().resolve("docs/behaviours").resolve(example), mine.resolve(example));
            }
            scenario.center();
            RunningProgram robot = scenario.robot("demo.map", "--speed", "5", "--behaviours", mine.toString());
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press ** #*4 **");
            phone.expect("tone", "key", "6");
            ConsoleEvent ahead = pressUntil(phone, robot, "2", pose -> pose.number("x") > 0.01);
            assertTrue(Math.abs(ahead.number("heading")) < 1, "2 drives straight ahead: " + ahead);
            ConsoleEvent turned = pressUntil(phone, robot, "4", pose -> pose.number("heading") > 1);
            assertTrue(turned.number("heading") < 180, "4 turns left: " + turned);
            phone.say("press **");
            robot.expect("behaviour", "value", "none");
            robot.expect("status", "value", "Stopped");
            phone.say("hangup");
            robot.expect("released");
            robot.ask("place 0 0 0", "pose");
            phone.say("sms " + Scenario.ROBOT + " ** #*3 **");
            assertEquals("6 Started process 3: Guard.", phone.expect("sms").field("text"));
            String report = phone.expect("sms", "from", Scenario.ROBOT).field("text");
            assertTrue(report.startsWith("Obstacle ahead of 0.") || report.startsWith("Obstacle ahead of 1."), report);
        }
    }

    /** Taps a key until the robot has moved so: a tap that lasts one late decision on a busy machine moves it little. */
    private static ConsoleEvent pressUntil(
            RunningProgram phone, RunningProgram robot, String key, Predicate<ConsoleEvent> moved) {
        ConsoleEvent pose;
        int taps = 0;
        do {
            assertTrue(taps++ < 50, key + " does not move the robot");
            phone.say("press " + key);
            robot.expect("keys", "keys", key);
            pose = robot.ask("pose", "pose");
        } while (!moved.test(pose));
        return pose;
    }
}
