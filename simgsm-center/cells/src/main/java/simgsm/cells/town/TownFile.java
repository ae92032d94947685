package simgsm.cells.town;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** A town file on disk. */
public final class TownFile {
    private TownFile() {}

    /** @throws IOException naming the file, and the line that is wrong with what was expected */
    public static Town read(Path file) throws IOException {
        String text;
        try {
            text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
        } catch (NoSuchFileException e) {
            throw new IOException(file + " is not there", e);
        }
        return TownReader.read(file.getFileName().toString(), text);
    }
}
