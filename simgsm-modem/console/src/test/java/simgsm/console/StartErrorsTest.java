package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StartErrorsTest {
    private final List<String> shown = new ArrayList<>();
    private final ByteArrayOutputStream error = new ByteArrayOutputStream();

    @Test
    void whatStopsAProgramIsPrintedAndShown() {
        assertEquals(ExitStatus.INPUT_OUTPUT, run(() -> new IOException("nope.map: no such file")));
        assertEquals(List.of("robot: nope.map: no such file"), shown);
        assertEquals("robot: nope.map: no such file", error.toString().strip());
    }

    @Test
    void aWrongOptionIsShownWhereThereIsNoTerminal() {
        assertEquals(ExitStatus.USAGE, run(() -> new IOException("not reached"), "--wrong"));
        assertEquals(System.console() == null ? 1 : 0, shown.size());
    }

    @Test
    void withoutAWindowTheErrorIsOnlyPrinted() {
        assertEquals(ExitStatus.INPUT_OUTPUT, run(() -> new IOException("port taken"), "--headless"));
        assertEquals(ExitStatus.INPUT_OUTPUT, run(() -> new IOException("port taken"), "--batch=3"));
        assertEquals(List.of(), shown);
    }

    @Test
    void anEndInOrderShowsNothing() {
        assertEquals(ExitStatus.OK, program().run(List.of(), out(), out(), arguments -> ExitStatus.OK));
        assertEquals(List.of(), shown);
    }

    @ParameterizedTest
    @CsvSource({
        "'', WARNING",
        "--headless, INFO",
        "--batch=3, INFO",
        "--log-level=info, INFO",
        "--log-level=debug, FINE"
    })
    void aProgramWithAWindowLogsFromWarningsOnUnlessItsUserWantsMore(String option, String level) {
        List<String> words = option.isEmpty() ? List.of() : List.of(option);
        program().run(words, out(), out(), arguments -> {
            assertEquals(Level.parse(level), Logger.getLogger("simgsm").getLevel());
            return ExitStatus.OK;
        });
        assertEquals("", error.toString(java.nio.charset.StandardCharsets.UTF_8));
    }

    private int run(java.util.function.Supplier<Exception> failure, String... words) {
        return program().run(List.of(words), out(), out(), arguments -> {
            throw failure.get();
        });
    }

    private PrintStream out() {
        return new PrintStream(error, true);
    }

    private Program program() {
        Options options = new Options("robot", "A robot.").rows("include common\n--batch N");
        return new Program("robot", options)
                .showingErrors((program, text, arguments) -> shown.add(program + ": " + text), "headless", "batch");
    }
}
