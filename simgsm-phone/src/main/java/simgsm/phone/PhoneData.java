package simgsm.phone;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.Reader;
import java.lang.System.Logger.Level;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import simgsm.air.Msisdn;
import simgsm.console.FolderLock;
import simgsm.file.FileErrors;
import simgsm.file.FileReplacement;

/**
 * The file of {@code --data}: the data that one phone keeps from run to run, as Java properties in UTF-8. Phones of
 * other numbers may use the folder at the same time.
 */
final class PhoneData implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(PhoneData.class.getName());

    private final Path file;
    private Map<String, String> known = Map.of();
    /** Texts that could not be written, for example to a full disk; null for none. */
    private Map<String, String> unwritten;

    private final FolderLock lock;

    private PhoneData(FolderLock lock, String name) {
        this.lock = lock;
        file = lock.folder().resolve(name + ".properties");
    }

    /** @throws IOException naming the folder if it cannot be made, or is used by a phone of that number */
    static PhoneData take(Path folder, Msisdn number) throws IOException {
        String name = "phone-" + number;
        return new PhoneData(FolderLock.take(folder, name + ".lock", "another phone " + number), name);
    }

    /** @throws IOException naming an existing file that cannot be read */
    Map<String, String> read() throws IOException {
        Properties properties = new Properties();
        if (!Files.exists(file)) {
            lock.hold(file);
            return Map.of();
        }
        try (Reader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
            properties.load(in);
        } catch (IllegalArgumentException | CharacterCodingException e) {
            throw new IOException(file + ": expected properties in UTF-8, " + e.getMessage(), e);
        }
        lock.hold(file);
        Map<String, String> texts = new TreeMap<>();
        properties.forEach((key, text) -> texts.put((String) key, (String) text));
        known = texts;
        return texts;
    }

    /**
     * Writes changes since the last call in one step: a killed program leaves the old file or the new one. A failed
     * write is repeated with the next change and at the end.
     */
    void write(Map<String, String> texts) {
        unwritten = null;
        if (texts.equals(known)) {
            return;
        }
        Properties properties = new Properties();
        properties.putAll(texts);
        try {
            // Octets, not characters: so every character outside ASCII is escaped, including half a surrogate pair.
            ByteArrayOutputStream octets = new ByteArrayOutputStream();
            properties.store(octets, null);
            lock.release();
            try {
                FileReplacement.writePrivately(file, octets.toByteArray());
            } finally {
                lock.hold(file);
            }
            known = Map.copyOf(texts);
        } catch (IOException e) {
            unwritten = Map.copyOf(texts);
            LOG.log(Level.WARNING, "--data is not kept: {0}", FileErrors.describe(e));
        }
    }

    @Override
    public void close() {
        if (unwritten != null) {
            write(unwritten);
        }
        lock.close();
    }
}
