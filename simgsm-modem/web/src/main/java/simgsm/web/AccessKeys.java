package simgsm.web;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simgsm.file.SecretFile;
import simgsm.file.Utf8Text;

/** The keys of programs that act for operators: {@code name=key} per line; {@code #} begins a line of comment. */
public final class AccessKeys {
    private static final String NAME = "[\\p{L}\\p{N}_.+-]{1,64}";
    /** Characters permitted in a header field and in JSON. */
    private static final String KEY = "[!-~]{1,200}";

    private final Map<String, byte[]> keys = new LinkedHashMap<>();
    private final GuessLimit guesses = new GuessLimit();

    private AccessKeys() {}

    /** One key for all programs of this operator. */
    public static AccessKeys of(String operator, String key) {
        AccessKeys keys = new AccessKeys();
        keys.keys.put(operator, key.getBytes(StandardCharsets.US_ASCII));
        return keys;
    }

    /**
     * Reads a file, and logs a warning if every user of this machine may read it.
     *
     * @throws IOException naming the file and, for invalid content, the line and the expected form, but no keys
     */
    public static AccessKeys read(Path file) throws IOException {
        List<String> lines = Utf8Text.read(file).lines().map(String::strip).toList();
        SecretFile.check(file);
        AccessKeys keys = new AccessKeys();
        Map<String, Integer> lineOf = new HashMap<>();
        for (int i = 0; i < lines.size(); i++) {
            try {
                keys.add(lines.get(i), i + 1, lineOf);
            } catch (IllegalArgumentException e) {
                throw new IOException(file + ", line " + (i + 1) + ": " + e.getMessage(), e);
            }
        }
        if (keys.keys.isEmpty()) {
            throw new IOException(file + ": expected a line name=key, found none");
        }
        return keys;
    }

    private void add(String line, int number, Map<String, Integer> lineOf) {
        if (line.isEmpty() || line.startsWith("#")) {
            return;
        }
        String[] parts = line.split("\\s*=\\s*", 2);
        if (parts.length < 2 || !parts[0].matches(NAME) || !parts[1].matches(KEY)) {
            throw new IllegalArgumentException("expected name=key, a name of 1 to 64 letters, digits and _ . + -"
                    + " and a key of 1 to 200 visible ASCII characters");
        }
        requireNew("name", "name " + parts[0], number, lineOf);
        requireNew("key", "key " + parts[1], number, lineOf);
        keys.put(parts[0], parts[1].getBytes(StandardCharsets.US_ASCII));
    }

    private static void requireNew(String what, String value, int number, Map<String, Integer> lineOf) {
        Integer before = lineOf.put(value, number);
        if (before != null) {
            throw new IllegalArgumentException("expected each " + what + " once, found that of line " + before);
        }
    }

    /**
     * The operator with this key. The run time does not depend on the keys' characters. Any thread may call it;
     * simultaneous guesses are counted one after the other.
     *
     * @param from the client's address; its guesses are limited
     * @throws RequestException with status 401 for a wrong key, 429 for one too many guesses
     */
    public synchronized String operator(String key, InetAddress from, long nowNanos) throws RequestException {
        guesses.require(from, nowNanos);
        byte[] given = key.getBytes(StandardCharsets.UTF_8);
        String operator = null;
        for (Map.Entry<String, byte[]> each : keys.entrySet()) {
            operator = MessageDigest.isEqual(each.getValue(), given) ? each.getKey() : operator;
        }
        if (operator == null) {
            guesses.countWrong(from, nowNanos);
            throw new RequestException(WebResponse.UNAUTHORIZED, "wrong key");
        }
        return operator;
    }
}
