package simrobot.world;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/** Saves worlds. */
public final class MapFile {
    private MapFile() {}

    /**
     * Saves the world as a {@code .map}: whole or not at all, so that a full disk leaves the old file.
     *
     * @throws IOException saying which file cannot be written, and why
     */
    public static void save(World world, Path file) throws IOException {
        Path target = Files.isSymbolicLink(file) ? file.toRealPath() : file;
        if (Files.isDirectory(target)) {
            throw new IOException(file + ": expected a file, found a folder");
        }
        if (Files.exists(target) && !Files.isWritable(target)) {
            throw new IOException(file + ": the file is write-protected");
        }
        // Not a temporary file of the JDK's: those are for the owner's eyes only.
        Path fresh = target.resolveSibling("." + target.getFileName() + ".new");
        try {
            try {
                Files.writeString(fresh, MapWriter.text(world), StandardCharsets.UTF_8);
                Files.move(fresh, target, StandardCopyOption.REPLACE_EXISTING);
            } finally {
                Files.deleteIfExists(fresh);
            }
        } catch (NoSuchFileException e) {
            throw new IOException(file + ": the folder does not exist", e);
        } catch (AccessDeniedException e) {
            throw new IOException(file + ": the folder is write-protected", e);
        }
    }
}
