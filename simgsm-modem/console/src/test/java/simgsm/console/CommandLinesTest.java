package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CommandLinesTest {
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final Console console = new Console(new PrintStream(printed, false, StandardCharsets.UTF_8));
    private final List<String> performed = new ArrayList<>();

    @BeforeEach
    void ready() {
        console.ready(Event.of("ready"));
    }

    /** @param octets one a character */
    private boolean run(String octets) throws Exception {
        CommandLines lines =
                new CommandLines("l.txt", new ByteArrayInputStream(octets.getBytes(StandardCharsets.ISO_8859_1)));
        return console.run(lines, command -> performed.add((command.name() + " " + command.rest()).strip()));
    }

    private List<String> errors() {
        return printed.toString(StandardCharsets.UTF_8).lines().skip(1).toList();
    }

    @ParameterizedTest
    @ValueSource(strings = {"abc", "", "1e3", "NaN", "0x1p3", "101", "-1", "99999999999", "1.5f", "٣"})
    void aWordThatIsNoNumberWithinBoundsIsRefusedWithTheBoundsAndTheWord(String word) {
        CommandException refused = assertThrows(
                CommandException.class, () -> ConsoleCommand.parse("volume x").number(word, 0, 100));
        assertEquals("volume: expected a number of 0 to 100, found " + word, refused.getMessage());
    }

    @Test
    void numbersWithinBoundsAreRead() throws Exception {
        assertEquals(100, ConsoleCommand.parse("volume x").number("100", 0, 100));
        assertEquals(-0.5, ConsoleCommand.parse("place x").number("-0.5", -1, 1));
    }

    @Test
    void allEndsOfLinesAreUnderstoodAndTheLastNeedsNone() throws Exception {
        assertFalse(run("a\nb\r\nc\rd\n\ne"));
        assertEquals(List.of("a", "b", "c", "d", "e"), performed);
        assertTrue(run("quit"));
    }

    @Test
    void aLineThatIsNotUtf8IsAnErrorThatNamesLineAndOctet() throws Exception {
        assertTrue(run("status\nexport ma\u00F1.csv\npose\nquit\n"));
        assertEquals(List.of("status", "pose"), performed);
        assertEquals(List.of("error text=\"l.txt, line 2, octet 10: expected UTF-8, found F1\""), errors());
    }

    @Test
    void aByteOrderMarkIsNoPartOfTheFirstLine() throws Exception {
        run("\u00EF\u00BB\u00BFstatus\n");
        assertEquals(List.of("status"), performed);
    }

    @Test
    void aLineWithANulOrTooLongIsAnErrorAndTheNextIsPerformed() throws Exception {
        run("a\u0000b\nstatus\n" + "x".repeat(CommandLines.MAX_OCTETS + 1) + "\npose\n");
        assertEquals(List.of("status", "pose"), performed);
        assertEquals(
                List.of(
                        "error text=\"l.txt, line 1, octet 2: expected text, found 00\"",
                        "error text=\"l.txt, line 3, expected at most 1048576 octets, found 1048577\""),
                errors());
    }

    @Test
    void binaryInputEndsAfterTenLines() {
        String binary = "\u0000\u00FF\n".repeat(CommandLines.MAX_BINARY);
        IOException failure = assertThrows(IOException.class, () -> run(binary + "status\n"));
        assertEquals("l.txt: expected lines of text, found binary data", failure.getMessage());
        assertEquals(List.of(), performed);
    }

    @Test
    void latinLinesHoweverManyAreNotBinary() throws Exception {
        run("sms 1 ma\u00F1ana\n".repeat(3 * CommandLines.MAX_BINARY) + "status\n");
        assertEquals(List.of("status"), performed);
        assertEquals(3 * CommandLines.MAX_BINARY, errors().size());
    }
}
