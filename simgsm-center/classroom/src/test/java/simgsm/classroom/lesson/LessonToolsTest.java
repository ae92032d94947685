package simgsm.classroom.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Students' programs that end, and that do not. */
@Timeout(60)
class LessonToolsTest {
    @TempDir
    Path folder;

    private Process start(String body) throws IOException {
        Path source = Files.writeString(
                folder.resolve("Student.java"),
                "class Student { public static void main(String[] words) { " + body + " } }");
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        return new ProcessBuilder(java, source.toString())
                .redirectErrorStream(true)
                .start();
    }

    @Test
    void anOutputIsReadToItsEnd() throws Exception {
        LessonTools.Printed printed = LessonTools.ended(start("System.out.print(\"sum 3\"); System.exit(4);"), 30);
        assertEquals(new LessonTools.Printed(4, "sum 3"), printed);
    }

    @Test
    void aProgramThatNeverEndsIsEnded() throws Exception {
        Process endless = start("while (true) { }");
        IOException failure = assertThrows(IOException.class, () -> LessonTools.ended(endless, 1));
        assertTrue(failure.getMessage().contains("within 1 s"), failure.getMessage());
        assertTrue(endless.waitFor(30, TimeUnit.SECONDS));
    }

    @Test
    void ofALongOutputTheBeginningIsKept() throws Exception {
        String body = "byte[] many = new byte[3 << 20]; System.out.write(many, 0, many.length); System.out.flush();";
        LessonTools.Printed printed = LessonTools.ended(start(body), 30);
        assertEquals(0, printed.status());
        assertEquals(LessonTools.MOST_OUTPUT, printed.output().length());
    }

    @Test
    void aProgramEndsWithTheLessonThatWaitsForIt() throws Exception {
        Process endless = start("while (true) { }");
        Thread.currentThread().interrupt();
        assertThrows(InterruptedException.class, () -> LessonTools.ended(endless, 30));
        assertTrue(endless.waitFor(30, TimeUnit.SECONDS));
        assertFalse(endless.isAlive());
    }
}
