package simgsm.phone;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.console.Program;

/** The command line. */
class PhoneMainTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int run(String... args) {
        return new Program("simgsm-phone", PhoneMain.options())
                .run(
                        List.of(args),
                        new PrintStream(out, true, StandardCharsets.UTF_8),
                        new PrintStream(err, true, StandardCharsets.UTF_8),
                        PhoneMain::run);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--number=robot | --number",
                "--number=12345678901234567 | --number",
                "--number=abc | --number: expected 1 to 10 digits and no leading zero, found abc",
                "--number=12345678901 | --number: expected 1 to 10 digits and no leading zero, found 12345678901",
                "--number=0555 | --number: expected 1 to 10 digits and no leading zero, found 0555",
                "--imei=123 | --imei",
                "--center=nowhere | --center",
                "--center=localhost:0 | --center",
                "--lang=fr | --lang",
                "--theme=pink | --theme",
                "--window=left | --window",
                "--codec=mp3 | --codec",
                "--dtmf=loud | --dtmf",
                "--seed=x | --seed",
                "--volume=11 | --volume",
            })
    void aWrongOptionIsNamedAndTheStatusIs2(String option, String named) {
        assertEquals(2, run(option));
        assertTrue(err.toString(StandardCharsets.UTF_8).contains(named), err.toString(StandardCharsets.UTF_8));
        assertTrue(err.toString(StandardCharsets.UTF_8).contains("--help"));
        assertEquals("", out.toString(StandardCharsets.UTF_8));
    }

    @Test
    void helpNamesEveryOption() {
        assertEquals(0, run("--help"));
        String help = out.toString(StandardCharsets.UTF_8);
        for (String option : List.of(
                "--number",
                "--center",
                "--headless",
                "--script",
                "--lang",
                "--no-sound",
                "--seed",
                "--imei",
                "--codec",
                "--dtmf",
                "--end-with-input")) {
            assertTrue(help.contains(option), option);
        }
    }
}
