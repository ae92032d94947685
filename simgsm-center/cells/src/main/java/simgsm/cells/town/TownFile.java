package simgsm.cells.town;

import java.io.IOException;
import java.nio.file.Path;
import simgsm.file.Utf8Text;

/** A town file on disk. */
public final class TownFile {
    private TownFile() {}

    /** @throws IOException naming the file, and the wrong line with the expected text */
    public static Town read(Path file) throws IOException {
        return TownReader.read(file.getFileName().toString(), Utf8Text.read(file));
    }
}
