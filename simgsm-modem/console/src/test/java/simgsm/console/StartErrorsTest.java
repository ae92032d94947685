package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

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

    private int run(java.util.function.Supplier<Exception> failure, String... words) {
        return program().run(List.of(words), out(), out(), arguments -> {
            throw failure.get();
        });
    }

    private PrintStream out() {
        return new PrintStream(error, true);
    }

    private Program program() {
        Options options = Program.commonOptions("robot", "A robot.").value("batch", "N", "runs");
        return new Program("robot", options)
                .showingErrors((program, text, arguments) -> shown.add(program + ": " + text), "headless", "batch");
    }
}
