package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Ends processes, so each is one of its own. */
@Timeout(60)
class FatalErrorTest {
    /** A program that would live for ever, and whose parting hangs if it is told to. */
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
        ProcessBuilder builder = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                place(FatalError.class) + System.getProperty("path.separator") + place(Doomed.class),
                Doomed.class.getName());
        builder.command().addAll(java.util.List.of(arguments));
        return builder.start();
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
}
