package simgsm.classroom.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.console.Event;

/** Consoles of small programs: an echo that ends with its input, and programs that end at once. */
@Timeout(120)
class ConsolesTest {
    @TempDir
    Path folder;

    private final BlockingQueue<String> told = new LinkedBlockingQueue<>();
    private final Consoles consoles = new Consoles();

    private void listen() {
        consoles.listen(new Consoles.Listener() {
            @Override
            public void line(String name, String line) {
                told.add(name + " " + line);
            }

            @Override
            public void lessonChosen(String lesson) {
                told.add("lesson " + lesson);
            }

            @Override
            public void ended(String name, int status, boolean isFault) {
                told.add(String.format(Locale.ROOT, "%s ended %d %b", name, status, isFault));
            }
        });
    }

    private static Process java(String... words) throws IOException {
        String[] command = new String[words.length + 1];
        command[0] = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        System.arraycopy(words, 0, command, 1, words.length);
        return new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
    }

    private void attachEcho() throws IOException {
        Path source = Files.writeString(
                folder.resolve("Echo.java"),
                "class Echo { public static void main(String[] words) throws Exception { System.in.transferTo(System.out); } }");
        consoles.attach("echo", java(source.toString()));
    }

    @ParameterizedTest
    @CsvSource({"-version, 0", "--no-such-option, 1"})
    void aProgramThatEndsBeforeItIsReadyIsAFault(String option, int status) throws Exception {
        listen();
        consoles.attach("phone", java(option));
        assertEquals("phone ended " + status + " true", told.take());
        SessionFailure failure = assertThrows(SessionFailure.class, () -> consoles.perform("phone wait registered"));
        assertEquals("phone: expected registered, but the program has ended", failure.getMessage());
        assertFalse(consoles.isRunning("phone"));
    }

    @Test
    void aProgramThatIsStoppedIsNone() throws Exception {
        attachEcho();
        consoles.perform("echo ready at=4711");
        consoles.perform("echo wait ready at=4711 60");
        assertEquals("4711", consoles.ready("echo").orElseThrow().fields().get("at"));
        assertEquals(Set.of("echo"), consoles.running());
        listen();
        consoles.perform("stop echo");
        assertEquals("echo ended 0 false", told.take());
    }

    @Test
    void aWaitPassesOverWhatIsNotWanted() throws Exception {
        listen();
        attachEcho();
        consoles.perform("echo tone key=1");
        consoles.perform("echo pose x=0.2004");
        consoles.perform("echo pose x=\"");
        consoles.perform("echo lesson name=twelve-keys");
        assertEquals("echo > tone key=1", told.take());
        consoles.perform("echo wait pose x=0.2+-0.001 60");
        consoles.perform("echo wait lesson 60");
        assertTrue(told.contains("lesson twelve-keys"), told.toString());
        assertTrue(told.stream().anyMatch(line -> line.startsWith("echo that line is no event: ")), told.toString());
        consoles.add("echo", Event.of("tone").with("key", 2));
        assertEquals(
                "2", consoles.await("echo", "tone", 60).fields().get("key"), "key 1 came before what was waited for");
        consoles.perform("stop echo");
    }

    @ParameterizedTest
    @CsvSource({
        "trace wait message 0.01, trace: expected message within 0.01 s",
        "trace wait message 601, 'wait: expected at most 600 s, found 601.0'",
        "nobody dial 1, 'expected a program, found nobody'",
        "stop nobody, 'expected a program, found nobody'"
    })
    void whatCannotBePerformedIsSaid(String line, String text) {
        assertEquals(
                text,
                assertThrows(SessionFailure.class, () -> consoles.perform(line)).getMessage());
    }
}
