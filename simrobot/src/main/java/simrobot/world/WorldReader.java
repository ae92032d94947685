package simrobot.world;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** Reads a world file, ARIA {@code .map} or Saphira {@code .wld}, selected by its extension. */
public final class WorldReader {
    /** Far above the largest known map (63 311 points, under 1 MB). */
    static final long MAX_FILE_BYTES = 64L << 20;

    private WorldReader() {}

    /**
     * Reads the world.
     *
     * @throws WorldFormatException naming file, line, the text found and the expected one
     * @throws IOException if the file cannot be read
     */
    public static World read(Path file) throws IOException {
        return read(file, octets(file));
    }

    /** Reads a world from a file's name and content. */
    public static World read(Path file, byte[] octets) throws WorldFormatException {
        String text = decode(octets);
        boolean saphira = file.toString().toLowerCase(Locale.ROOT).endsWith(".wld");
        String name = String.valueOf(file.getFileName());
        return saphira ? SaphiraReader.read(name, text) : MapReader.read(name, text);
    }

    /**
     * The content of a file of at most 64 MiB; devices and pipes are refused, because they may never end.
     *
     * @throws IOException naming the file, the type or size found and the expected one
     */
    public static byte[] octets(Path file) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new IOException(file + ": expected a regular file, found a folder, a device or a pipe");
        }
        try (InputStream in = Files.newInputStream(file)) {
            byte[] octets = Files.size(file) > MAX_FILE_BYTES ? null : in.readNBytes((int) MAX_FILE_BYTES + 1);
            if (octets == null || octets.length > MAX_FILE_BYTES) {
                throw new IOException(file + ": over 64 MiB, expected at most that");
            }
            return octets;
        }
    }

    /** Decodes UTF-8, or Latin-1 if it is no valid UTF-8, as in old maps. */
    static String decode(byte[] bytes) {
        try {
            String text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
            return text.startsWith("\uFEFF") ? text.substring(1) : text;
        } catch (CharacterCodingException notUtf8) {
            return new String(bytes, StandardCharsets.ISO_8859_1);
        }
    }
}
