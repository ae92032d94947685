package simgsm.center.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringReader;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.msc.Exchange;
import simgsm.center.net.PortLimits;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.sim.SimFile;

class CenterConsoleTest {
    @TempDir
    Path temporary;

    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final Console console = new Console(new PrintStream(printed, false, StandardCharsets.UTF_8));
    private CenterSettings settings;
    private Center center;

    @BeforeEach
    void open() throws IOException {
        settings = new CenterSettings(
                InetAddress.getLoopbackAddress(),
                OptionalInt.empty(),
                OptionalInt.empty(),
                Optional.empty(),
                Optional.empty(),
                OptionalInt.empty(),
                Optional.empty(),
                new HomeSettings(Optional.empty(), SimFile.EMPTY, Set.of(), ""),
                new SplittableRandom(1),
                Locale.ENGLISH,
                Optional.empty(),
                PortLimits.STANDARD,
                false,
                false,
                30,
                Optional.empty(),
                HandoverAlgorithm.STANDARD);
        center = Center.open(settings, temporary, 0);
    }

    @Test
    void aSecondCentreIsRefusedAlsoWhenTheLockFileIsDeleted() throws IOException {
        Files.delete(temporary.resolve("lock"));

        IOException failure = assertThrows(IOException.class, () -> Center.open(settings, temporary, 0));

        assertEquals(
                "cannot read the messages in " + temporary + ": another centre holds reserve", failure.getMessage());
    }

    @AfterEach
    void close() {
        center.close();
    }

    private List<String> linesAfter(String commands) throws Exception {
        try (Console closing = console) {
            center.start(closing::tell);
            console.ready(Event.of("ready").with("port", "1234"));
            console.run(new BufferedReader(new StringReader(commands)), new CenterCommands(center, closing));
        }
        return printed.toString(StandardCharsets.UTF_8).lines().toList();
    }

    @Test
    void aRepeatedBroadcastIsListedUntilItIsStopped() throws Exception {
        String running = "broadcast id=1 channel=50 language=es update=0 pages=1 every=60 sent=1 text=\"mucho ruido\"";
        assertEquals(
                List.of(
                        "ready port=1234",
                        running,
                        running,
                        "end of=broadcasts count=1",
                        "broadcast id=1 channel=50 language=\"\" update=1 pages=1 every=30 sent=1 left=4 text=nada",
                        "error text=\"broadcast stop: no broadcast 1 is repeated\"",
                        "end of=broadcasts count=0"),
                linesAfter(
                        "broadcast lang=es every=60 50 mucho ruido\nbroadcasts\n"
                                + "broadcast update=1 times=5 50 nada\nbroadcast stop 1\nbroadcast stop 1\nbroadcasts\nquit\n"));
    }

    @Test
    void whatIsWrongBeforeTheChannelIsNamed() throws Exception {
        assertEquals(
                List.of(
                        "ready port=1234",
                        "error text=\"broadcast: expected lang= and two letters, found lang=Spanish\"",
                        "error text=\"broadcast: expected every= and a number, found every=often\"",
                        "error text=\"broadcast: a period of 0 s is not 1 to 86400 s\"",
                        "error text=\"broadcast: 0 times is not 1 to 65535\"",
                        "error text=\"broadcast: no broadcast 7 is repeated\""),
                linesAfter("broadcast lang=Spanish 50 x\nbroadcast every=often 50 x\nbroadcast every=0 50 x\n"
                        + "broadcast times=0 50 x\nbroadcast update=7 50 x\nquit\n"));
    }

    @Test
    void aMessageThatIsNoneIsAnError() throws Exception {
        assertEquals(
                List.of(
                        "ready port=1234",
                        "error text=\"message: expected message ID, found nothing after it\"",
                        "error text=\"message: expected an id as messages lists it, found x\"",
                        "error text=\"message: expected one that waits or has lately ended, found 7\""),
                linesAfter("message\nmessage x\nmessage 7\nquit\n"));
    }

    @Test
    void everyListIsClosedByItsCount() throws Exception {
        assertEquals(
                List.of(
                        "ready port=1234",
                        "end of=subscribers count=0",
                        "end of=calls count=0",
                        "end of=messages count=0"),
                linesAfter("subscribers\ncalls\nmessages\nwait end of=messages\nquit\n"));
    }

    @Test
    void whatIsWrongIsSaidAndTheConsoleGoesOn() throws Exception {
        assertEquals(
                List.of(
                        "ready port=1234",
                        "error text=\"unknown command dance, expected subscribers, calls, messages, message, broadcast, broadcasts, class, handover, wait or"
                                + " quit\"",
                        "error text=\"calls: expected nothing after it, found please\"",
                        "error text=\"broadcast: expected CHANNEL TEXT, found nothing after it\"",
                        "error text=\"broadcast: expected CHANNEL TEXT, found hello all\"",
                        "error text=\"broadcast: expected CHANNEL TEXT, found an empty text\"",
                        "error text=\"broadcast: broadcast channel 65536 is not 0 to 65535\"",
                        "end of=calls count=0"),
                linesAfter(
                        "dance\ncalls please\nbroadcast\nbroadcast hello all\nbroadcast 50 \"\"\nbroadcast 65536 hello\n"
                                + "broadcast 50 \"hello \\u00e1 all\"\ncalls\n"));
    }

    @Test
    void bothLanguagesHaveTheSameKeys() {
        assertEquals(keys("messages"), keys("messages_es"));
    }

    private static List<String> keys(String bundle) {
        return Collections.list(ResourceBundle.getBundle("simgsm.center.app." + bundle, Locale.ROOT)
                        .getKeys())
                .stream()
                .sorted()
                .toList();
    }

    @Test
    @Timeout(20)
    void aQuestionToAClosedCentreFailsAtOnce() {
        center.start(event -> {});
        center.close();
        assertThrows(IllegalStateException.class, () -> center.ask(Exchange::linkCount));
    }
}
