package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.PrintStream;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ConsoleTest {
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final Console console = new Console(new PrintStream(printed, false, StandardCharsets.UTF_8));

    private boolean run(String... lines) throws Exception {
        String text = String.join("\n", lines) + "\n";
        return console.run(new BufferedReader(new StringReader(text)), command -> {
            switch (command.name()) {
                case "echo" -> console.emit(Event.of("echo").with("text", command.text()));
                case "two" -> console.emit(Event.of("two").with("words", command.words(2, "A B")));
                default -> throw new CommandException("unknown command " + command.name());
            }
        });
    }

    private List<String> lines() {
        return printed.toString(StandardCharsets.UTF_8).lines().toList();
    }

    @Test
    void readyIsTheFirstLineWhateverHappenedBefore() {
        console.emit(Event.of("registered").with("number", "5550100"));
        console.ready(Event.of("ready").with("port", 3003));
        assertEquals(List.of("ready port=3003", "registered number=5550100"), lines());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "**#**20**|text=**#**20**",
                "a b|text=\"a b\"",
                "\"\"|text=\"\"",
                "\"say \\\"hola\\\"\"|text=\"say \\\"hola\\\"\"",
                "\"two\\nlines\"|text=\"two\\nlines\"",
                "ñandú|text=\"ñandú\"",
                "\"\\u00f1\"|text=\"ñ\"",
                "a=b|text=\"a=b\""
            })
    void valuesStandBareOrQuotedAsTheyNeed(String argument, String field) throws Exception {
        console.ready(Event.of("ready"));
        run("echo " + argument);
        assertEquals(List.of("ready", "echo " + field), lines());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "bogus",
                "echo \"open",
                "echo \"a\" b",
                "echo \"\\x\"",
                "echo \"\\u12g4\"",
                "two one",
                "two a b c",
                "quit now",
                "wait",
                "wait a b c",
                "wait a=b",
                "wait a -1",
                "wait a 1e3",
                "wait a NaN",
                "wait a 0x1p3",
                "wait a 1d",
                "wait a =b 1"
            })
    void aMalformedLineIsAnErrorAndTheProgramGoesOn(String line) throws Exception {
        console.ready(Event.of("ready"));
        assertFalse(run(line, "echo on"));
        List<String> lines = lines();
        assertEquals(3, lines.size(), lines.toString());
        assertTrue(lines.get(1).startsWith("error text=\""), lines.get(1));
        assertEquals("echo text=on", lines.get(2));
        assertEquals(ExitStatus.OK, console.exitStatus());
    }

    @Test
    void blankLinesAreNothing() throws Exception {
        console.ready(Event.of("ready"));
        run("", "   ", "\t");
        assertEquals(List.of("ready"), lines());
    }

    @Test
    void quitEndsBeforeTheRest() throws Exception {
        console.ready(Event.of("ready"));
        assertTrue(run("quit", "echo never"));
        assertEquals(List.of("ready"), lines());
    }

    @Test
    void waitLooksFromTheCursorOnAndSetsItBehindItsMatch() throws Exception {
        console.ready(Event.of("ready"));
        run("echo a", "echo b", "echo a", "wait ready", "wait echo text=a 0", "wait echo text=a 0");
        assertEquals(ExitStatus.OK, console.exitStatus());
        run("wait echo text=b 0");
        assertEquals(ExitStatus.FAILED, console.exitStatus(), "b lies before the cursor");
    }

    @Test
    void aWaitThatTimesOutSetsTheCursorToTheEnd() throws Exception {
        console.ready(Event.of("ready"));
        run("echo a", "wait nothing 0", "wait echo text=a 0");
        assertEquals(
                List.of(
                        "ready",
                        "echo text=a",
                        "error text=\"wait: no nothing within 0 s\"",
                        "error text=\"wait: no echo text=a within 0 s\""),
                lines());
        assertEquals(ExitStatus.FAILED, console.exitStatus());
    }

    @Test
    void theErrorOfAWaitThatTimesOutLiesBeforeTheCursor() throws Exception {
        console.ready(Event.of("ready"));
        run("wait nothing 0", "wait error 0");
        assertEquals(
                2, lines().stream().filter(line -> line.startsWith("error ")).count());
    }

    @Test
    void whereCommandsAreAddressedWaitAndQuitAreToo() throws Exception {
        console.ready(Event.of("ready"));
        Console.Commands addressed = new Console.Commands() {
            @Override
            public void perform(ConsoleCommand command) throws CommandException {
                throw new CommandException("unexpected " + command);
            }

            @Override
            public boolean areAddressed() {
                return true;
            }
        };
        String text = "@robot wait ready 0\n@robot quit\nnever\n";
        assertTrue(console.run(new BufferedReader(new StringReader(text)), addressed));
        assertEquals(List.of("ready"), lines());
        assertFalse(run("@robot wait ready 0"), "elsewhere @robot is no command");
        assertTrue(lines().get(1).startsWith("error "), lines().toString());
    }

    @Test
    void aQueuePrintsInOrderAndAllThatIsLeftAtItsEnd() {
        EventOutputQueue queue =
                new EventOutputQueue(new PrintStream(printed, false, StandardCharsets.UTF_8), () -> {});
        for (int i = 0; i < 1000; i++) {
            queue.print(Event.of("row").with("n", i));
        }
        queue.close();
        assertEquals(1000, lines().size());
        assertEquals("row n=999", lines().get(999));
    }

    @Test
    void printingIntoAQueueIsNotDelayedByAStoppedReader() throws Exception {
        PipedOutputStream stuck = new PipedOutputStream(new PipedInputStream(16));
        EventOutputQueue queue = new EventOutputQueue(new PrintStream(stuck, false, StandardCharsets.UTF_8), () -> {});
        for (int i = 0; i < 100_000; i++) {
            queue.print(Event.of("row").with("n", i));
        }
        assertEquals(0, printed.size(), "the loop has ended although its output is not read");
    }

    @Test
    void theThreadThatReadsCommandsWaitsWhileTheirAnswersAreNotRead() throws Exception {
        PipedInputStream reader = new PipedInputStream(16);
        PipedOutputStream stuck = new PipedOutputStream(reader);
        EventOutputQueue queue =
                new EventOutputQueue(new PrintStream(stuck, false, StandardCharsets.UTF_8), () -> {}, 10_000);
        queue.awaitRoom();
        for (int i = 0; i < 100; i++) {
            queue.print(Event.of("row").with("n", i));
        }
        Thread commands = new Thread(() -> {
            try {
                queue.awaitRoom();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
        commands.start();
        while (commands.getState() != Thread.State.WAITING) {
            assertTrue(commands.isAlive(), "it does not wait, although nothing is read");
            Thread.onSpinWait();
        }
        assertEquals("row n=0\n", new String(reader.readNBytes(8), StandardCharsets.UTF_8));
        Thread drain = new Thread(() -> {
            try {
                reader.readAllBytes();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        });
        drain.setDaemon(true);
        drain.start();
        commands.join();
    }

    @Test
    void theLogForgetsItsOldestEventsBeyondItsMemory() throws Exception {
        EventBuffer buffer = new EventBuffer(100_000);
        for (int i = 0; i < 1_000; i++) {
            buffer.add(Event.of("laser").with("n", i).with("ranges", "9".repeat(1_000)));
        }
        assertTrue(buffer.await(Event.of("laser").with("n", 990), 0), "the newest are kept");
        for (int i = 1_000; i < 2_000; i++) {
            buffer.add(Event.of("laser").with("n", i).with("ranges", "9".repeat(1_000)));
        }
        assertFalse(buffer.await(Event.of("laser").with("n", 1_800), 0), "the oldest are gone");
        buffer.add(Event.of("laser").with("n", 1).with("ranges", "9".repeat(1_000_000)));
        assertTrue(buffer.await(Event.of("laser").with("n", 1), 0), "one event always has room");
    }

    @ParameterizedTest
    @ValueSource(strings = {"\\ud800", "\\udc00", "x\\udc00\\ud800y", "\\u+041", "\\u-001"})
    void aQuotedTextIsWhatItSaysOrAnError(String escaped) throws Exception {
        run("echo \"" + escaped + "\"", "echo \"\\ud83d\\ude00\"");
        assertTrue(lines().isEmpty());
        console.ready(Event.of("ready"));
        assertTrue(lines().get(1).startsWith("error text=\"\\\\u"), lines().toString());
        assertEquals("echo text=\"\uD83D\uDE00\"", lines().get(2));
    }

    @Test
    void anErrorQuotesOfALongLineTheBeginning() throws Exception {
        console.ready(Event.of("ready"));
        run("\uD83D\uDE00".repeat(500_000));
        String error = lines().get(1);
        assertTrue(error.length() < 5_000, error.length() + " characters");
        assertTrue(error.endsWith("\uD83D\uDE00 ...\""), error.substring(error.length() - 10));
    }

    @Test
    void waitComparesQuotedValuesAsStrings() throws Exception {
        console.ready(Event.of("ready"));
        run("echo No motors", "wait echo text=\"No motors\" 0");
        assertEquals(ExitStatus.OK, console.exitStatus());
    }

    @Test
    void waitIsWokenByAnEventFromAnotherThread() throws Exception {
        console.ready(Event.of("ready"));
        Thread other = new Thread(() -> console.emit(Event.of("tone").with("key", 3)));
        other.start();
        run("wait tone key=3 60");
        other.join();
        assertEquals(ExitStatus.OK, console.exitStatus());
    }

    @Test
    void theLogForgetsItsOldestEventsBeyondItsLimit() throws Exception {
        console.ready(Event.of("ready"));
        console.emit(Event.of("first"));
        for (int i = 0; i < EventBuffer.MAX_UNREAD; i++) {
            console.emit(Event.of("filler"));
        }
        run("wait first 0");
        assertEquals(ExitStatus.FAILED, console.exitStatus());
    }
}
