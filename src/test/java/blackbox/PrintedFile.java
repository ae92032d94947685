package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A file of {@code docs} that the code prints; {@code -Duml.write=true} writes it anew. */
public final class PrintedFile {
    /** Whether printed files are written instead of only compared. */
    public static final boolean IS_WRITING = Boolean.getBoolean("uml.write");

    private PrintedFile() {}

    /** Requires that the file holds this text, or writes it. */
    public static void hold(Path file, String text) throws IOException {
        if (IS_WRITING) {
            Files.createDirectories(file.getParent());
            Files.writeString(file, text);
        }
        assertEquals(
                text,
                Files.exists(file) ? Files.readString(file).replace("\r", "") : "no such file",
                file + " has drifted from the code; docs/uml/README.md says how to write it anew");
    }
}
