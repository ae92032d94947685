package simgsm.web;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * The head of a request (RFC 9112, 2 to 5).
 *
 * @param path as requested: not decoded, without the query
 * @param query after the question mark; empty if there is none
 * @param isPersistent whether the connection stays open for a further request
 * @param fields by their names in small letters; the values of equal names are joined by commas
 */
public record WebRequest(String method, String path, String query, boolean isPersistent, Map<String, String> fields) {
    /** A header field's value. */
    public Optional<String> field(String name) {
        return Optional.ofNullable(fields.get(name.toLowerCase(Locale.ROOT)));
    }

    /** Whether only the header of the answer is asked for. */
    public boolean isHead() {
        return method.equals("HEAD");
    }

    /** Whether a body follows, which no page reads. */
    boolean hasBody() {
        return fields.containsKey("transfer-encoding")
                || !fields.getOrDefault("content-length", "0").equals("0");
    }
}
