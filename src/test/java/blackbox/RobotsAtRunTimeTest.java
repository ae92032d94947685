package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Robots that come while SimRobot runs have a telephone of their own; what is to be seen of them can be exported. */
class RobotsAtRunTimeTest {
    private static final String NUMBER = "5550277";

    @Test
    void aRobotThatIsAddedRegistersTakesCallsObeysAndIsGoneWhenItIsRemoved() throws Exception {
        try (Scenario scenario = new Scenario("a robot comes and goes")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--speed=10");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            robot.say("add anna=" + NUMBER + " 3 4 90");
            robot.expect("added", "robot", "anna", "number", NUMBER);
            robot.expect("registered", "robot", "anna", "number", NUMBER);
            phone.say("dial " + NUMBER);
            phone.expect("connected", "number", NUMBER);
            phone.expect("tone", "key", "1");
            phone.say("press **#**20**");
            robot.expect("outcome", "robot", "anna", "tone", "3");
            robot.say("@anna pose");
            robot.expect("pose", "robot", "anna", "x", "3.0000", "y", "4.2000", "heading", "90.00");
            phone.expect("tone", "key", "3");
            robot.say("@anna remove");
            robot.expect("removed", "robot", "anna");
            phone.expect("released");
            robot.say("robots");
            robot.expect("end", "of", "robots", "count", "1");
            phone.say("dial " + NUMBER);
            phone.expect("released");
            assertEquals(0, phone.quit());
            assertEquals(0, robot.quit());
        }
    }

    @Test
    void anotherWorldIsLoadedWhileRunningAndAFileThatIsNoneChangesNothing() throws Exception {
        try (Scenario scenario = new Scenario("another world while running")) {
            RunningProgram robot = scenario.start(
                    "robot",
                    "simrobot",
                    "--headless",
                    "--center=127.0.0.1:1",
                    "--world=" + Scenario.world("empty.map"));
            robot.expect("ready");
            robot.say("world");
            robot.expect("world", "name", "empty.map");
            robot.say("world " + Scenario.world("office.map"));
            robot.expect("world", "name", "office.map", "lines", "19", "points", "72", "homes", "8");
            robot.say("pose");
            robot.expect("pose", "x", "9.0000", "y", "6.0000", "heading", "0.00");
            robot.say("world nowhere.map");
            assertTrue(robot.expect("error").field("text").contains("nowhere.map: no such file"));
            robot.say("world");
            robot.expect("world", "name", "office.map");
            assertEquals(0, robot.quit());
        }
    }

    @Test
    void aNameANumberOrAPlaceThatIsTakenIsRefusedAndNothingIsAdded() throws Exception {
        try (Scenario scenario = new Scenario("robots that cannot be added")) {
            RunningProgram robot = scenario.start(
                    "robot",
                    "simrobot",
                    "--headless",
                    "--center=127.0.0.1:1",
                    "--world=" + Scenario.world("empty.map"));
            robot.expect("ready");
            robot.say("add robot=" + NUMBER);
            assertTrue(robot.expect("error").field("text").contains("is there already"));
            robot.say("add anna=" + Scenario.ROBOT);
            assertTrue(robot.expect("error").field("text").contains("another robot has the number"));
            robot.say("add anna=" + NUMBER + " 500 0 0");
            assertTrue(robot.expect("error").field("text").contains("outside the world"));
            robot.say("export world.gif");
            assertTrue(robot.expect("error").field("text").contains(".png, .svg or .csv"));
            robot.say("robots");
            robot.expect("end", "of", "robots", "count", "1");
            assertEquals(0, robot.quit());
        }
    }

    @Test
    void theWorldAndATrackAreExported() throws Exception {
        try (Scenario scenario = new Scenario("exports")) {
            scenario.center();
            RunningProgram robot = scenario.robot("office.map", "--speed=10");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            phone.say("sms " + Scenario.ROBOT + " **#**30**");
            robot.expect("outcome", "tone", "3");
            Path svg = scenario.folder().resolve("world.svg");
            Path png = scenario.folder().resolve("world.png");
            Path csv = scenario.folder().resolve("track.csv");
            robot.say("export " + svg).expect("exported", "file", svg.toString());
            robot.say("export " + png).expect("exported", "file", png.toString());
            robot.say("export " + csv).expect("exported", "file", csv.toString());
            assertTrue(Files.readString(svg).contains("<svg xmlns=\"http://www.w3.org/2000/svg\""));
            byte[] picture = Files.readAllBytes(png);
            assertEquals("PNG", new String(picture, 1, 3, StandardCharsets.US_ASCII));
            List<String> lines = Files.readAllLines(csv);
            assertEquals("time s,x m,y m,heading degrees,status", lines.get(0));
            assertTrue(lines.stream().anyMatch(line -> line.endsWith(",Moving")), lines.toString());
            assertTrue(lines.get(lines.size() - 1).endsWith(",Stopped"), lines.toString());
            robot.say("export " + scenario.folder().resolve("none").resolve("w.svg"));
            assertTrue(robot.expect("error").field("text").contains("expected a folder that is there"));
        }
    }
}
