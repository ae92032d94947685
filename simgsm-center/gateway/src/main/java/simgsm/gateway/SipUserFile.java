package simgsm.gateway;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import simgsm.air.Msisdn;
import simgsm.file.SecretFile;
import simgsm.file.Utf8Text;

/** The SIP phones that may register: {@code number=password} per line of {@code sip-users.properties}. */
final class SipUserFile {
    private static final String NAME = "sip-users.properties";

    private SipUserFile() {}

    /** @throws IOException naming the file, and the number of a wrong line */
    static Map<String, String> read(Path folder) throws IOException {
        Path file = folder.resolve(NAME);
        Properties lines = new Properties();
        String text = Utf8Text.read(file);
        SecretFile.check(file);
        try {
            lines.load(new StringReader(text));
            Map<String, String> users = new TreeMap<>();
            for (String number : lines.stringPropertyNames()) {
                String password = lines.getProperty(number).strip();
                if (password.isEmpty()) {
                    throw new IllegalArgumentException("expected a password after " + number + "=");
                }
                users.put(new Msisdn(number).digits(), password);
            }
            return users;
        } catch (IllegalArgumentException e) {
            throw new IOException(file + ": expected lines number=password: " + e.getMessage(), e);
        }
    }
}
