package simrobot.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.sim.SimSlot;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.World;

class RequestedRobotsTest {
    private static World homes(String... names) {
        return World.of(
                "w",
                Stream.of(names)
                        .map(name -> new Home(name, new Position(0, 0), 0))
                        .toList());
    }

    private static List<String> lineup(World world, String... options) throws UsageException, IOException {
        Arguments arguments = SimRobotOptions.all().parse(List.of(options));
        return RequestedRobots.of(arguments, SimSlot.of(arguments.path("sim")), world).stream()
                .map(robot -> robot.name() + "=" + robot.number())
                .toList();
    }

    @Test
    void aSingleRobotIsCalledRobot() throws Exception {
        assertEquals(List.of("robot=5550200"), lineup(World.bare()));
        assertEquals(List.of("robot=42"), lineup(World.bare(), "--number=42"));
    }

    @Test
    void theOnlyCardOfAFileGivesTheSingleRobotItsNumber(@TempDir Path folder) throws Exception {
        String keys = " k=465b5ce8b199b49faa5f0a2ee238a6bc opc=cd63cb71954a9f4e48a5994e37a02baf\n";
        Path one = Files.writeString(folder.resolve("one"), "sim number=77 imsi=001010000000077" + keys);
        Path two = Files.writeString(
                folder.resolve("two"), Files.readString(one) + "sim number=78 imsi=001010000000078" + keys);
        assertEquals(List.of("robot=77"), lineup(World.bare(), "--sim", one.toString()));
        assertEquals(List.of("robot=5"), lineup(World.bare(), "--sim", one.toString(), "--number=5"));
        assertEquals(List.of("a=78"), lineup(World.bare(), "--sim", two.toString(), "--robot=a=78"));
        assertThrows(UsageException.class, () -> lineup(World.bare(), "--sim", two.toString()));
    }

    @Test
    void namedRobotsComeInTheirOrder() throws Exception {
        assertEquals(
                List.of("ana=5550201", "b-2=5550200"),
                lineup(World.bare(), "--robot", "ana=5550201", "--robot=b-2=+5550200"));
    }

    @Test
    void everyHomeGetsARobotNamedAfterItWithNumbersCountingUp() throws Exception {
        assertEquals(
                List.of("Home=5550199", "In_the_hall=5550200", "robot=5550201", "Home-2=5550202"),
                lineup(homes("Home", "In the hall", "", "Home"), "--robots=all", "--number=5550199"));
    }

    @ParameterizedTest
    @CsvSource({
        "--number=abc,--number",
        "--number=12345678901,--number",
        "--number=0123,--number",
        "--robot=ana,NAME=NUMBER",
        "--robot=a b=5,robot's name",
        "--robot=@a=5,robot's name",
        "--robot=a=x,--robot",
        "--robots=some,--robots"
    })
    void aWrongLineupIsNamed(String option, String words) {
        String message = assertThrows(UsageException.class, () -> lineup(World.bare(), option))
                .getMessage();
        assertTrue(message.contains(words), message);
    }

    @Test
    void twoRobotsCannotShareANameOrANumber() {
        assertThrows(UsageException.class, () -> lineup(World.bare(), "--robot=a=1", "--robot=a=2"));
        assertThrows(UsageException.class, () -> lineup(World.bare(), "--robot=a=1", "--robot=b=1"));
        assertThrows(UsageException.class, () -> lineup(homes("a", "b"), "--robots=all", "--number=9999999999"));
    }

    @ParameterizedTest
    @CsvSource({
        "--operators=5550100;5550101",
        "--operators=",
        "--operators=*",
        "--operators=62*45",
        "--on-hangup=maybe",
        "--lang=fr"
    })
    void wrongSettingsAreNamed(String option) throws Exception {
        Arguments arguments = SimRobotOptions.all().parse(List.of(option));
        String message = assertThrows(UsageException.class, () -> SimRobotOptions.settings(arguments))
                .getMessage();
        assertTrue(message.startsWith(option.substring(0, option.indexOf('='))), message);
    }

    @Test
    void operatorsAreAListOfNumbersAndOfTheirBeginnings() throws Exception {
        Arguments arguments = SimRobotOptions.all().parse(List.of("--operators", "5550100, +5550101, 6245*"));
        assertEquals(
                java.util.Set.of("5550100", "5550101", "6245*"),
                SimRobotOptions.settings(arguments).operators());
    }

    @Test
    void aWorldWithoutHomesHasOneRobot() throws Exception {
        assertEquals(List.of("robot=5550200"), lineup(homes(), "--robots=all"));
    }
}
