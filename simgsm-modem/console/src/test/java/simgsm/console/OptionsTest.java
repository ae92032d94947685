package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class OptionsTest {
    private final Options options = new Options("java -jar x.jar [options]", "Does x.").rows("""
            include common
            --center HOST:PORT
                where the centre is
                es: la dirección de la central
            --port N
                TCP port
            --speed N
                pace
            --trace [FILE]
                a trace
            --robot NAME=NUMBER ...
                a robot
            """);

    private Arguments parse(String... words) throws UsageException {
        return options.parse(List.of(words));
    }

    @Test
    void aValueFollowsAsAWordOrAfterAnEqualsSign() throws Exception {
        assertEquals(Optional.of("a:1"), parse("--center", "a:1").text("center"));
        assertEquals(Optional.of("a:1"), parse("--center=a:1").text("center"));
        assertEquals(Optional.of(""), parse("--center=").text("center"));
    }

    @Test
    void theLastOfTwoWinsButACollectingOptionKeepsBoth() throws Exception {
        assertEquals(Optional.of("2"), parse("--port", "1", "--port", "2").text("port"));
        assertEquals(
                List.of("a=1", "b=2"), parse("--robot", "a=1", "--robot=b=2").all("robot"));
    }

    @Test
    void aSwitchIsThereOrNot() throws Exception {
        assertTrue(parse("--headless").has("headless"));
        assertFalse(parse().has("headless"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--bogus|unknown option --bogus",
                "-x|unknown option -x",
                "--center|--center needs a value: HOST:PORT",
                "--headless=yes|--headless takes no value, found yes",
                "stray|unexpected argument stray"
            })
    void aBrokenLineNamesWhatWasWrong(String word, String text) {
        assertEquals(text, assertThrows(UsageException.class, () -> parse(word)).getMessage());
    }

    @Test
    void numbersAreHeldToTheirBounds() throws Exception {
        assertEquals(0, parse("--port", "0").integer("port", 3003, 0, 65535));
        assertEquals(65535, parse("--port", "65535").integer("port", 3003, 0, 65535));
        assertEquals(3003, parse().integer("port", 3003, 0, 65535));
        for (long bound : new long[] {Long.MIN_VALUE, Long.MAX_VALUE}) {
            assertEquals(bound, parse("--port=" + bound).integer("port", 0, Long.MIN_VALUE, Long.MAX_VALUE));
        }
        UsageException beyond = assertThrows(
                UsageException.class, () -> parse("--port=9223372036854775808").integer("port", 0, 0, Long.MAX_VALUE));
        assertTrue(beyond.getMessage().endsWith("found 9223372036854775808"), beyond.getMessage());
        assertEquals(0.1, parse("--speed", ".1").number("speed", 1, 0.01, 1000));
        for (String wrong : List.of("65536", "-1", "x", "1.5", "")) {
            UsageException e = assertThrows(
                    UsageException.class, () -> parse("--port=" + wrong).integer("port", 3003, 0, 65535));
            assertEquals("--port: expected a whole number of 0 to 65535, found " + wrong, e.getMessage());
        }
    }

    @ParameterizedTest
    @CsvSource({"127.0.0.1:3003,127.0.0.1,3003", "[::1]:1,::1,1", "host:65535,host,65535"})
    void aHostAndPortAreReadApart(String text, String host, int port) throws Exception {
        assertEquals(
                Optional.of(new HostPort(host, port)), parse("--center", text).hostPort("center"));
        assertEquals(text, new HostPort(host, port).toString());
    }

    @ParameterizedTest
    @CsvSource({"host", ":3003", "host:", "host:0", "host:65536", "::1:3003"})
    void aBrokenHostAndPortIsRefused(String text) throws Exception {
        Arguments arguments = parse("--center", text);
        assertThrows(UsageException.class, () -> arguments.hostPort("center"));
    }

    @Test
    void theProgramTurnsWhatHappensIntoAnExitStatus() {
        assertEquals(7, status("", arguments -> 7));
        assertEquals(ExitStatus.USAGE, status("--bogus", arguments -> 0));
        assertEquals(ExitStatus.USAGE, status("--log-level=loud", arguments -> 0));
        assertEquals(ExitStatus.INPUT_OUTPUT, status("--headless", arguments -> {
            throw new IOException("port 3003 is taken");
        }));
        assertEquals(ExitStatus.FAILED, status("--headless", arguments -> {
            throw new IllegalStateException("broken");
        }));
        assertEquals(ExitStatus.OK, status("-h", arguments -> 7));
        assertEquals(ExitStatus.OK, status("--version", arguments -> 7));
    }

    @Test
    void helpNamesEveryOption() {
        String help = options.help(false);
        for (String option : List.of("--center HOST:PORT", "--robot NAME=NUMBER", "--headless", "-h, --help", "-V")) {
            assertTrue(help.contains(option), option);
        }
    }

    @Test
    void helpIsInSpanishWhereARowHasASpanishText() {
        String help = options.help(true);
        assertTrue(help.startsWith("Uso: java -jar x.jar [options]\n\nDoes x.\n\nOpciones:\n"), help);
        assertTrue(help.contains("\n      --center HOST:PORT      la dirección de la central\n"), help);
        assertTrue(help.contains("\n      --port N                TCP port\n"), help);
    }

    @Test
    void theDotsOfARepeatableOptionAreNotInTheHelp() {
        assertTrue(options.help(false).contains("\n      --robot NAME=NUMBER     a robot\n"));
    }

    @Test
    void aValueInBracketsMayBeLeftOut() throws Exception {
        assertEquals(Optional.of(""), parse("--trace", "--headless").text("trace"));
        assertEquals(Optional.of("f"), parse("--trace", "f").text("trace"));
    }

    @Test
    void anOptionHasOneRowOnly() {
        assertThrows(IllegalArgumentException.class, () -> options.rows("--port N"));
    }

    private int status(String word, Program.Body body) {
        PrintStream nowhere = new PrintStream(new ByteArrayOutputStream(), false, StandardCharsets.UTF_8);
        return new Program("x", options).run(word.isEmpty() ? List.of() : List.of(word), nowhere, nowhere, body);
    }
}
