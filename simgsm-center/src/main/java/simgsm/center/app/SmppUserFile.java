package simgsm.center.app;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Properties;
import simgsm.center.smpp.SmppUsers;
import simgsm.file.SecretFile;
import simgsm.file.Utf8Text;

/** The applications that may bind by SMPP: {@code system-id=password}, a line each, and {@code system-id.SETTING=value}. */
final class SmppUserFile {
    static final String NAME = "smpp-users.properties";

    private SmppUserFile() {}

    /**
     * Reads the file of a data directory; without it any local application may bind.
     *
     * @throws IOException naming the file if it cannot be read or holds what SMPP cannot carry
     */
    static SmppUsers read(Path data) throws IOException {
        Path file = data.resolve(NAME);
        Properties lines = new Properties();
        try {
            lines.load(new StringReader(Utf8Text.read(file)));
        } catch (NoSuchFileException e) {
            return SmppUsers.anyLocal();
        } catch (IllegalArgumentException e) {
            throw new IOException(file + ": " + e.getMessage(), e);
        }
        SecretFile.check(file);
        Map<String, String> users = new LinkedHashMap<>();
        lines.stringPropertyNames().forEach(key -> users.put(key, lines.getProperty(key)));
        try {
            return SmppUsers.only(users);
        } catch (IllegalArgumentException e) {
            throw new IOException(file + ": " + e.getMessage(), e);
        }
    }
}
