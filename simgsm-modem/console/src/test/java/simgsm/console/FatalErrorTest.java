package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Ends processes, so each is one of its own. */
@Timeout(60)
class FatalErrorTest {
    /** A program that does not end by itself, and whose shutdown hook hangs on request. */
    public static final class Doomed {
        public static void main(String[] args) throws InterruptedException {
            if (args.length > 0) {
                Runtime.getRuntime().addShutdownHook(new Thread(Doomed::hang));
            }
            FatalError.end("doomed", new LinkageError("on purpose"));
            hang();
        }

        private static void hang() {
            try {
                Thread.sleep(Long.MAX_VALUE);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private static Process doomed(String... arguments) throws Exception {
        ProcessBuilder builder = command(Doomed.class);
        builder.command().addAll(List.of(arguments));
        return builder.start();
    }

    private static ProcessBuilder command(Class<?> program) throws Exception {
        String classPath = place(FatalError.class) + System.getProperty("path.separator") + place(program);
        return new ProcessBuilder(new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                classPath,
                program.getName())));
    }

    private static Path place(Class<?> of) throws Exception {
        return Path.of(of.getProtectionDomain().getCodeSource().getLocation().toURI());
    }

    @Test
    void theProgramEndsWithStatus1AndSaysWhy() throws Exception {
        Process doomed = doomed();
        String said = new String(doomed.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(
                "doomed: ended by an error of its own: java.lang.LinkageError: on purpose",
                said.lines().reduce((first, second) -> second).orElseThrow());
        assertTrue(doomed.waitFor(50, TimeUnit.SECONDS));
        assertEquals(ExitStatus.FAILED, doomed.exitValue());
    }

    @Test
    void aPartingThatHangsIsCutShort() throws Exception {
        Process doomed = doomed("hang");
        try {
            assertTrue(doomed.waitFor(50, TimeUnit.SECONDS));
            assertEquals(ExitStatus.FAILED, doomed.exitValue());
        } finally {
            doomed.destroyForcibly();
        }
    }

    /** A program whose main thread lives on when another has run out of memory. */
    public static final class Hoarder {
        public static void main(String[] args) {
            FatalError.endOnMachineErrors("hoarder");
            new Thread(Hoarder::hoard).start();
            Doomed.hang();
        }

        private static void hoard() {
            List<byte[]> all = new ArrayList<>();
            while (true) {
                all.add(new byte[100_000]);
            }
        }
    }

    @Test
    void aProgramOutOfMemorySaysSoAndEnds() throws Exception {
        ProcessBuilder builder = command(Hoarder.class);
        builder.command().add(1, "-Xmx16m");
        Process hoarder = builder.start();
        try {
            String said = new String(hoarder.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
            assertTrue(said.contains("ended: out of memory (java.lang.OutOfMemoryError)"), said);
            assertTrue(hoarder.waitFor(50, TimeUnit.SECONDS));
            assertEquals(ExitStatus.FAILED, hoarder.exitValue());
        } finally {
            hoarder.destroyForcibly();
        }
    }
}
