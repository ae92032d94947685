package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How every program answers its command line: help, version, clear usage errors, the right exit status. */
class CommandLineTest {
    @ParameterizedTest
    @CsvSource({
        "simgsm-center,-h,--version",
        "simgsm-cells,--help,-V",
        "simgsm-gateway,--help,--version",
        "simgsm-phone,--help,-V",
        "simrobot,-h,-V",
        "simgsm-modem,--help,--version",
        "vericommand,-h,--version"
    })
    void helpAndVersionGoToStandardOutputWithStatusZero(String program, String forHelp, String forVersion)
            throws Exception {
        FinishedProgram help = FinishedProgram.run(program, forHelp);
        assertEquals(0, help.status(), help.error());
        assertTrue(help.output().startsWith("Usage: "), help.output());
        FinishedProgram version = FinishedProgram.run(program, forVersion);
        assertEquals(0, version.status());
        assertTrue(version.output().matches(program + " [0-9]+\\.[0-9]+\\.[0-9]+\\R"), version.output());
    }

    @ParameterizedTest
    @CsvSource({
        "simgsm-center,--bogus",
        "simgsm-center,--port=x",
        "simgsm-center,--port=65536",
        "simgsm-cells,--bogus",
        "simgsm-cells,--town",
        "simgsm-cells,--controller=theirs",
        "simgsm-phone,--bogus",
        "simgsm-phone,--number=abc",
        "simgsm-phone,--number=12345678901",
        "simgsm-phone,--center=nowhere",
        "simgsm-phone,--lang=fr",
        "simrobot,--bogus",
        "simrobot,--speed=-1",
        "simrobot,--on-hangup=maybe",
        "simrobot,--power=maybe",
        "simrobot,--operators=5550100;5550101",
        "simgsm-modem,--bogus",
        "vericommand,--bogus",
        "vericommand,--status=Flying"
    })
    void aWrongOptionIsNamedWithStatusTwo(String program, String option) throws Exception {
        FinishedProgram refused = FinishedProgram.run(program, "--headless".equals(option) ? "" : option);
        assertEquals(2, refused.status(), refused.error());
        String name = option.contains("=") ? option.substring(0, option.indexOf('=')) : option;
        assertTrue(refused.error().contains(name), refused.error());
        assertTrue(refused.error().contains("--help"), refused.error());
        assertFalse(refused.error().contains("\tat "), refused.error());
        assertEquals("", refused.output());
    }

    @ParameterizedTest
    @ValueSource(strings = {"simgsm-center", "simgsm-phone", "simrobot"})
    void withoutADisplayAndWithoutHeadlessTheStatusIs69(String program, @TempDir Path data) throws Exception {
        FinishedProgram refused = program.equals("simgsm-center")
                ? FinishedProgram.run(program, "--port=0", "--data", data.toString())
                : FinishedProgram.run(program, "--number=5550199");
        assertEquals(69, refused.status(), refused.error());
        assertTrue(refused.error().contains("--headless"), refused.error());
    }

    @Test
    void aWorldThatIsNotThereIsAnInputOutputError() throws Exception {
        FinishedProgram refused =
                FinishedProgram.run("simrobot", "--headless", "--number=5550199", "--world=worlds/nowhere.map");
        assertEquals(74, refused.status(), refused.error());
        assertTrue(refused.error().contains("nowhere.map"), refused.error());
    }

    @Test
    void aPortThatIsTakenIsAnInputOutputError() throws Exception {
        try (Scenario scenario = new Scenario("two centres, one port")) {
            scenario.center();
            String port =
                    scenario.centerAddress().substring(scenario.centerAddress().lastIndexOf(':') + 1);
            FinishedProgram second = FinishedProgram.run(
                    "simgsm-center",
                    "--headless",
                    "--port",
                    port,
                    "--data",
                    scenario.folder().resolve("other").toString());
            assertEquals(74, second.status(), second.error());
            assertTrue(second.error().contains(port), second.error());
        }
    }

    @Test
    void twoCentresCannotShareTheirData() throws Exception {
        try (Scenario scenario = new Scenario("two centres, one folder")) {
            scenario.center();
            String data = scenario.folder().resolve("data").toString();
            FinishedProgram second = FinishedProgram.run("simgsm-center", "--headless", "--port=0", "--data", data);
            assertEquals(74, second.status(), second.error());
            assertTrue(second.error().contains(data), second.error());
        }
    }

    @Test
    void aScriptRunsBeforeStandardInputAndAFailedWaitIsStatusOne(@TempDir Path folder) throws Exception {
        try (Scenario scenario = new Scenario("a script")) {
            scenario.center();
            Path script = Files.writeString(
                    folder.resolve("script.txt"), "wait registered number=5550100\nwait ringing 0.1\nquit\n");
            FinishedProgram phone = FinishedProgram.run(
                    "simgsm-phone",
                    "--headless",
                    "--number=5550100",
                    "--center",
                    scenario.centerAddress(),
                    "--script",
                    script.toString());
            assertEquals(1, phone.status(), phone.error());
            assertTrue(phone.output().startsWith("ready"), phone.output());
            assertTrue(phone.output().contains("registered number=5550100"), phone.output());
            assertTrue(phone.output().contains("error text="), phone.output());
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "vericommand|** #**20 **",
                "simgsm-modem|pdu;encode;hi",
                "simrobot|--print-world",
                "simgsm-center|--lessons",
                "simgsm-phone|--headless;--no-sound;--serve;--center;127.0.0.1:1"
            })
    @EnabledOnOs(OS.LINUX)
    void outputThatCannotBeWrittenIsAnInputOutputError(String program, String words) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(Dist.command(program, List.of(words.split(";"))));
        builder.redirectOutput(new File("/dev/full"));
        FinishedProgram full = FinishedProgram.of(builder, new byte[0]);
        assertEquals(74, full.status(), full.error());
        assertTrue(full.error().contains(program + ": standard output"), full.error());
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void closedStandardInputIsItsEnd() throws Exception {
        List<String> command = new ArrayList<>(List.of("sh", "-c", "exec \"$@\" <&-", "sh"));
        command.addAll(Dist.command("simrobot", List.of("--headless", "--no-sound", "--center=127.0.0.1:1")));
        FinishedProgram ended = FinishedProgram.of(new ProcessBuilder(command), new byte[0]);
        assertEquals(0, ended.status(), ended.error());
        assertFalse(ended.output().contains("error"), ended.output());
    }

    @Test
    void anOctetThatIsNotUtf8IsAnErrorOfItsLineInAScriptAndOnStandardInput(@TempDir Path folder) throws Exception {
        byte[] lines =
                "\u00EF\u00BB\u00BFpose\nexport ma\u00F1.csv\nstatus\nquit\n".getBytes(StandardCharsets.ISO_8859_1);
        Path script = Files.write(folder.resolve("l.txt"), lines);
        List<String> options = List.of("--headless", "--no-sound", "--center=127.0.0.1:1");
        List<String> scripted = new ArrayList<>(options);
        scripted.addAll(List.of("--script", script.toString()));
        requireOneError(
                FinishedProgram.of(new ProcessBuilder(Dist.command("simrobot", options)), lines), "standard input");
        requireOneError(
                FinishedProgram.of(new ProcessBuilder(Dist.command("simrobot", scripted)), new byte[0]),
                script.toString());
    }

    private static void requireOneError(FinishedProgram program, String input) {
        assertEquals(0, program.status(), program.error());
        String error = "error text=\"" + input + ", line 2, octet 10: expected UTF-8, found F1\"";
        List<String> answers = program.output()
                .lines()
                .filter(line -> line.matches("(pose|error|status) .*"))
                .toList();
        assertEquals(3, answers.size(), program.output());
        assertTrue(answers.get(0).startsWith("pose "), program.output());
        assertEquals(error, answers.get(1));
        assertTrue(answers.get(2).startsWith("status "), program.output());
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void anArgumentThatTheLocaleDamagesIsAUsageError() throws Exception {
        List<String> command =
                new ArrayList<>(List.of("sh", "-c", "LC_ALL=C exec \"$@\" \"$(printf 'ma\\361ana')\"", "sh"));
        command.addAll(Dist.command("simgsm-modem", List.of("pdu", "encode")));
        FinishedProgram refused = FinishedProgram.of(new ProcessBuilder(command), new byte[0]);
        assertEquals(2, refused.status(), refused.error());
        assertTrue(refused.error().contains("UTF-8 locale"), refused.error());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "simgsm-phone|--zoom=5",
                "simgsm-phone|--theme=x",
                "simrobot|--window=x",
                "simrobot|--robots=all;--robot=a=1",
                "simrobot|--replay-from=5",
                "simgsm-center|--bind=",
                "simgsm-phone|--data=",
                "simrobot|--world=worlds/empty.map;--record=worlds/empty.map"
            })
    void aValueThatWouldBeIgnoredIsRefused(String program, String words) throws Exception {
        List<String> options = new ArrayList<>(List.of("--headless"));
        options.addAll(List.of(words.split(";")));
        FinishedProgram refused = FinishedProgram.run(program, options, Map.of());
        assertEquals(2, refused.status(), refused.error());
    }

    @Test
    void aResultThatCannotBeWrittenIsRefusedBeforeTheLesson() throws Exception {
        FinishedProgram refused = FinishedProgram.run(
                "simgsm-center", "--lesson=twelve-keys", "--check=right", "--result=nowhere/result.txt");
        assertEquals(74, refused.status(), refused.error());
        assertTrue(refused.error().contains("no such folder"), refused.error());
        assertEquals("", refused.output());
    }

    @Test
    void simRobotPrintsTheWorldItLoaded() throws Exception {
        FinishedProgram printed = FinishedProgram.run("simrobot", "--print-world", "--world=worlds/empty.map");
        assertEquals(0, printed.status(), printed.error());
        assertEquals(
                4,
                printed.output()
                        .lines()
                        .filter(line -> line.startsWith("line,"))
                        .count(),
                printed.output());
        assertEquals(
                1,
                printed.output()
                        .lines()
                        .filter(line -> line.startsWith("home,"))
                        .count());
    }
}
