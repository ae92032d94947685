package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ProgramTest {
    private final ByteArrayOutputStream error = new ByteArrayOutputStream();

    /** @param reason why nothing can be written */
    private static StandardOutput broken(String reason) {
        return new StandardOutput(new OutputStream() {
            @Override
            public void write(int octet) throws IOException {
                throw new IOException(reason);
            }
        });
    }

    private int run(PrintStream out, String... args) {
        Program program = new Program("tool", new Options("tool", "A tool.").arguments(2));
        return program.run(List.of(args), out, new PrintStream(error, true, StandardCharsets.UTF_8), arguments -> {
            out.print("result\n");
            return ExitStatus.OK;
        });
    }

    private String error() {
        return error.toString(StandardCharsets.UTF_8);
    }

    @ParameterizedTest
    @ValueSource(strings = {"--help", "--version", "word"})
    void aResultThatCannotBeWrittenIsAnInputOutputError(String word) {
        assertEquals(ExitStatus.INPUT_OUTPUT, run(broken("No space left on device"), word));
        assertEquals("tool: standard output: No space left on device\n", error());
    }

    @Test
    void anErrorOfOutputIsReportedOnce() {
        StandardOutput out = broken("No space left on device");
        run(out);
        out.hasFailed(new PrintStream(error, true, StandardCharsets.UTF_8));
        assertEquals("tool: standard output: No space left on device\n", error());
    }

    @Test
    void aReaderThatHasGoneAwayIsNoNews() {
        assertEquals(ExitStatus.INPUT_OUTPUT, run(broken("Broken pipe")));
        assertEquals("", error());
    }

    @Test
    void theFirstErrorOfEventsIsReportedOnce() {
        AtomicInteger lost = new AtomicInteger();
        EventOutputQueue queue = new EventOutputQueue(broken("No space left on device"), lost::incrementAndGet);
        queue.print(Event.of("ready"));
        queue.print(Event.of("registered"));
        queue.close();
        assertEquals(1, lost.get());
    }

    @Test
    void whatIsWrittenIsNoFailure() {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        StandardOutput out = new StandardOutput(octets);
        assertEquals(ExitStatus.OK, run(out));
        assertEquals("result\n", octets.toString(StandardCharsets.UTF_8));
    }

    @Test
    void anArgumentThatTheLocaleHasDamagedIsRefused() {
        assertEquals(ExitStatus.USAGE, run(new PrintStream(OutputStream.nullOutputStream()), "12", "\uFFFD\uFFFD.wav"));
        assertEquals(
                "tool: the argument \uFFFD\uFFFD.wav has characters that this locale cannot read;"
                        + " expected UTF-8 and a UTF-8 locale, as LC_ALL=C.UTF-8; see --help\n",
                error());
        assertEquals(ExitStatus.OK, run(new PrintStream(OutputStream.nullOutputStream()), "12", "\uD83D\uDE00.wav"));
    }
}
