package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class VeriCommandMainTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int run(String... args) {
        return VeriCommandMain.run(
                List.of(args),
                new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8));
    }

    private String out() {
        return out.toString(StandardCharsets.UTF_8).replace("\r", "");
    }

    private String err() {
        return err.toString(StandardCharsets.UTF_8);
    }

    @Test
    void anOrderThatCanBeExecutedIsAcceptedInWords() {
        assertEquals(0, run("--lang", "en", "** #**20 **"));
        assertEquals("** #**20 **\nforward 20 cm\naccepted\n", out());
    }

    @Test
    void aFaultIsMarkedUnderItsKeyWithBlanksInTheText() {
        assertEquals(1, run("--lang=en", "** #**\n**"));
        assertEquals(
                "** #** **\n       ^\n7 Not a valid command: number expected at key 6. Range 1..9999 cm.\n", out());
    }

    @Test
    void aMissingKeyIsMarkedAfterTheText() {
        assertEquals(1, run("--lang=en", "** ###"));
        assertEquals("** ###\n      ^\n7 Not a valid command: # or * expected at key 6.\n", out());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Stopped|** #**20 **|0|accepted",
                "Collision|** #**20 **|1|8 Not possible: collision.",
                "Collision|** #*#90 #**20 **|0|accepted",
                "No motors|** #*#20 **|1|8 Not possible: no motors.",
                "No motors|** ### **|1|8 Not possible: no motors.",
                "No motors|** #*0 **|0|accepted",
                "Moving|** #**20 **|1|6 Executing a command.",
                "Moving|** ### #*0 **|0|accepted",
                "Disconnected|** #*0 **|1|2 Connection denied: the robot is off."
            })
    void theStatusDecides(String status, String order, int exit, String words) {
        assertEquals(exit, run("--lang", "en", "--status", status, order));
        assertTrue(out().endsWith(words + "\n"), out());
    }

    @Test
    void theLastOfTwoEqualOptionsWinsAndTheTextIsSpanish() {
        assertEquals(1, run("--status=Stopped", "--lang=en", "--lang=es", "--status=Collision", "** #**20 **"));
        assertTrue(out().endsWith("8 No es posible: choque.\n"), out());
    }

    @ParameterizedTest
    @CsvSource({
        "--bogus,unknown option --bogus",
        "--help=yes,--help takes no value",
        "--status=Flying,--status",
        "--lang=fr,--lang",
        "--status,--status needs a value"
    })
    void aWrongOptionIsNamed(String option, String words) {
        assertEquals(2, run(option));
        assertTrue(err().contains(words) && err().contains("--help"), err());
        assertEquals("", out());
    }

    @Test
    void aRefusedOrderIsPrintedInWordsToo() {
        assertEquals(1, run("--lang=en", "--status=Moving", "** #*#90 **"));
        assertEquals("** #*#90 **\nturn right 90 degrees\n6 Executing a command.\n", out());
    }

    @Test
    void theOrderMayFollowTwoDashesAndConsistOfSeveralWords() {
        assertEquals(0, run("--lang=en", "--", "**", "#**20", "**"));
        assertEquals("** #**20 **\nforward 20 cm\naccepted\n", out());
        assertEquals(1, run("--lang=en", "--", "--status=Stopped"));
        assertTrue(out().endsWith("7 Not a valid command: ** expected at key 1.\n"), out());
    }

    @ParameterizedTest
    @CsvSource({"es-MX,aceptada", "en-GB,accepted", "fr,accepted"})
    void withoutTheOptionTheLanguageIsTheSystems(String system, String verdict) {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag(system));
            assertEquals(0, run("** #**20 **"));
            assertTrue(out().endsWith("\n" + verdict + "\n"), out());
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void withoutAnOrderThereIsNothingToJudge() {
        assertEquals(2, run());
        assertTrue(err().contains("no order"), err());
    }

    @Test
    void helpVersionAndDiagramAreAnswersOfTheirOwn() {
        assertEquals(0, run("--help"));
        assertTrue(out().startsWith("Usage: "), out());
        out.reset();
        assertEquals(0, run("-V"));
        assertTrue(out().matches("vericommand [0-9]+(\\.[0-9]+)+\\R"), out());
        out.reset();
        assertEquals(0, run("--diagram"));
        assertEquals(StatusMachine.TABLE.plantUml().replace("!include look.iuml\n", ""), out());
    }

    @Test
    void aVerdictThatCannotBeWrittenIsStatus74() {
        PrintStream full = new PrintStream(
                new OutputStream() {
                    @Override
                    public void write(int octet) throws IOException {
                        throw new IOException("No space left on device");
                    }
                },
                true,
                StandardCharsets.UTF_8);
        PrintStream error = new PrintStream(err, true, StandardCharsets.UTF_8);
        assertEquals(74, VeriCommandMain.run(List.of("** #**20 **"), full, error));
        assertEquals(74, VeriCommandMain.run(List.of("--help"), full, error));
        assertTrue(err().startsWith("vericommand: standard output cannot be written"), err());
    }

    @Test
    void anArgumentThatTheLocaleHasDamagedIsRefused() {
        assertEquals(2, run("\uFFFD"));
        assertTrue(err().contains("UTF-8 locale"), err());
    }
}
