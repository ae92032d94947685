package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The page "Your first behaviour", step by step, and the examples that it names. */
class BehaviourPageTest {
    private static final Pattern BLOCK = Pattern.compile("```(java|console)\n(.*?)```", Pattern.DOTALL);
    private static final Pattern CLASS = Pattern.compile("public class (\\w+)");

    @Test
    void everyStepOfThePageGoesAsItStandsThere() throws Exception {
        String page = Files.readString(Dist.root().resolve("docs/BEHAVIOUR.md"));
        assertTrue(page.contains("java -jar target/dist/simrobot.jar --behaviours mine --world worlds/office.map"));
        try (Scenario scenario = new Scenario("the first behaviour of a student")) {
            Path mine = Files.createDirectory(scenario.folder().resolve("mine"));
            scenario.center();
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            List<RunningProgram> robot = new ArrayList<>();
            Matcher block = BLOCK.matcher(page);
            int blocks = 0;
            while (block.find()) {
                blocks++;
                if (block.group(1).equals("java")) {
                    save(mine, block.group(2));
                    continue;
                }
                if (robot.isEmpty()) {
                    robot.add(start(scenario, mine));
                }
                for (String line : block.group(2).lines().toList()) {
                    perform(line, robot.get(0), phone);
                }
            }
            assertEquals(12, blocks);
        }
    }

    private static void save(Path folder, String source) throws IOException {
        Matcher name = CLASS.matcher(source);
        assertTrue(name.find(), source);
        Files.writeString(folder.resolve(name.group(1) + ".java"), source);
    }

    private static RunningProgram start(Scenario scenario, Path folder) {
        return scenario.start(
                "robot",
                "simrobot",
                "--headless",
                "--no-sound",
                "--lang",
                "en",
                "--center",
                scenario.centerAddress(),
                "--behaviours",
                folder.toString(),
                "--world",
                Scenario.world("office.map").toString());
    }

    private static void perform(String line, RunningProgram robot, RunningProgram phone) {
        if (line.startsWith("> ")) {
            robot.say(line.substring(2));
        } else if (line.startsWith("phone> ")) {
            phone.say(line.substring(7));
        } else {
            ConsoleEvent expected = ConsoleEvent.parse(line);
            robot.expect(expected.name(), fields(expected.fields()));
        }
    }

    private static String[] fields(Map<String, String> fields) {
        return fields.entrySet().stream()
                .flatMap(field -> List.of(field.getKey(), field.getValue()).stream())
                .toArray(String[]::new);
    }

    @Test
    void theExampleFindsItsWayThroughTheMaze() throws Exception {
        RunningProgram robot;
        try (Scenario scenario = new Scenario("the maze solver")) {
            robot = example(scenario, "MazeSolver");
            robot.expect("behaviour", "value", "none");
            ConsoleEvent pose = robot.ask("pose", "pose");
            assertEquals(14.25, pose.number("x"), 0.7);
            assertEquals(14.25, pose.number("y"), 0.7);
        }
    }

    @Test
    void theDancerEndsByItselfNearWhereItBegan() throws Exception {
        try (Scenario scenario = new Scenario("the dance")) {
            RunningProgram robot = example(scenario, "Dance");
            robot.expect("behaviour", "value", "none");
            ConsoleEvent pose = robot.ask("pose", "pose");
            assertEquals(0.75, pose.number("x"), 0.6);
            assertEquals(0.75, pose.number("y"), 0.6);
        }
    }

    @Test
    void theWallFollowerGoesOnWithoutACollision(@TempDir Path folder) throws Exception {
        Path track = folder.resolve("track.csv");
        FinishedProgram run = FinishedProgram.run(
                "simrobot",
                "--behaviours",
                Dist.root().resolve("docs/behaviours").toString(),
                "--behaviour",
                "WallFollower",
                "--world",
                Scenario.world("office.map").toString(),
                "--robots",
                "all",
                "--run",
                "60",
                "--track",
                track.toString());
        assertEquals(1, run.status(), run.error());
        assertTrue(run.output().startsWith("ran robots=8 simulated=60.000"), run.output());
        List<String> lines = Files.readAllLines(track);
        Map<String, Set<String>> placesOfRobots = new TreeMap<>();
        for (String line : lines.subList(1, lines.size())) {
            String[] fields = line.split(",");
            assertNotEquals("Collision", fields[5], line);
            placesOfRobots.computeIfAbsent(fields[0], robot -> new HashSet<>()).add(fields[2] + " " + fields[3]);
        }
        assertEquals(8, placesOfRobots.size());
        placesOfRobots.forEach((robot, places) -> assertTrue(places.size() > 1, robot + " has not moved"));
    }

    @Test
    void deadReckoningDriftsAndPrintsHowFarAtEachCorner() throws Exception {
        FinishedProgram run = FinishedProgram.run(
                "simrobot",
                "--behaviours",
                Dist.root().resolve("docs/behaviours").toString(),
                "--behaviour",
                "DeadReckoning",
                "--world",
                Scenario.world("demo.map").toString(),
                "--noise",
                "3",
                "--seed",
                "1",
                "--run",
                "done");
        assertEquals(0, run.status(), run.error());
        List<String> printed = run.output()
                .lines()
                .filter(line -> line.startsWith("printed robot=robot name=DeadReckoning text=\"corner "))
                .toList();
        assertEquals(21, printed.size(), run.output());
        assertTrue(printed.get(0).endsWith("corner 0: off by 0.00 m\""), printed.get(0));
        assertFalse(printed.get(20).contains("off by 0.0"), printed.get(20));
    }

    @Test
    void eachExampleHasItsNumberSoThatNoStartChangesTheSourceTree() throws IOException {
        Path examples = Dist.root().resolve("docs/behaviours");
        String numbers = Files.readString(examples.resolve("numbers.txt"));
        try (Stream<Path> files = Files.list(examples)) {
            for (Path file : files.filter(each -> each.toString().matches(".*\\.(java|py)"))
                    .toList()) {
                String name = file.getFileName().toString().replaceFirst("\\..*", "");
                assertTrue(
                        Pattern.compile("(?m)^[0-9]+ " + name + "$")
                                .matcher(numbers)
                                .find(),
                        name);
            }
        }
    }

    private static RunningProgram example(Scenario scenario, String name) {
        RunningProgram robot = scenario.start(
                "robot",
                "simrobot",
                "--headless",
                "--no-sound",
                "--center",
                "127.0.0.1:1",
                "--speed",
                "30",
                "--behaviours",
                Dist.root().resolve("docs/behaviours").toString(),
                "--behaviour",
                name,
                "--world",
                Scenario.world("maze.map").toString());
        robot.expect("ready");
        return robot;
    }
}
