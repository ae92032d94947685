package simgsm.center.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.console.ProgramFolder;

/** Programs as child processes, here one that writes its arguments to a file and ends. */
class ChildProgramsTest {
    @TempDir
    Path folder;

    /** The program. */
    static final class Writer {
        private Writer() {}

        public static void main(String[] args) throws IOException {
            Path file = Path.of(args[0]);
            Files.writeString(file, (Files.exists(file) ? Files.readString(file) : "") + List.of(args) + "\n");
        }
    }

    private void jar(String name) throws IOException {
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, Writer.class.getName());
        String entry = Writer.class.getName().replace('.', '/') + ".class";
        try (OutputStream file = Files.newOutputStream(folder.resolve(name));
                JarOutputStream jar = new JarOutputStream(file, manifest)) {
            jar.putNextEntry(new JarEntry(entry));
            jar.write(Writer.class.getClassLoader().getResourceAsStream(entry).readAllBytes());
        }
    }

    @Test
    void aProgramThatHasEndedIsStartedAgainAsItWas() throws Exception {
        jar("simrobot.jar");
        Path file = folder.resolve("arguments");
        try (ChildPrograms children = new ChildPrograms(new ProgramFolder(folder, false))) {
            assertTrue(children.startAgain("simrobot.jar").isEmpty(), "none was started");
            List<String> arguments = List.of(file.toString(), "--headless", "--window", "300,0,900,600");
            children.start("simrobot.jar", "5550200", arguments, ProcessBuilder.Redirect.DISCARD)
                    .waitFor();
            assertTrue(children.startAgain("simgsm-phone.jar").isEmpty(), "another program");
            children.startAgain("simrobot.jar").orElseThrow().waitFor();
        }
        List<String> lines = Files.readAllLines(file);
        assertEquals(2, lines.size());
        assertEquals(lines.get(0), lines.get(1));
        assertTrue(lines.get(0).contains("300,0,900,600"), lines.get(0));
    }
}
