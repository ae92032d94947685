package simgsm.web;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The head of an HTTP/1.1 request (RFC 9112, 2 to 5).
 *
 * @param target as sent
 * @param fields by name without case; values of equal names are joined by a comma
 */
record HttpHead(String method, String target, String version, Map<String, String> fields) {
    /** @param text the lines of the head, without the empty one */
    static HttpHead parse(String text) throws RequestException {
        String[] lines = text.split("\r?\n", -1);
        String[] request = lines[0].split(" ");
        if (request.length != 3 || !request[2].startsWith("HTTP/1.")) {
            throw malformed("the request line");
        }
        Map<String, String> fields = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        for (String line : Arrays.asList(lines).subList(1, lines.length)) {
            int colon = line.indexOf(':');
            if (colon <= 0) {
                throw malformed("a header line");
            }
            fields.merge(line.substring(0, colon), line.substring(colon + 1).strip(), (one, more) -> one + ", " + more);
        }
        return new HttpHead(request[0], request[1], request[2], fields);
    }

    private static RequestException malformed(String what) {
        return new RequestException(WebResponse.BAD_REQUEST, "malformed request: " + what);
    }

    Optional<String> field(String name) {
        return Optional.ofNullable(fields.get(name));
    }

    /** True if a comma-separated field contains this token, in upper or lower case (RFC 9110, 5.6.1). */
    boolean contains(String name, String token) {
        return Arrays.stream(field(name).orElse("").toLowerCase(Locale.ROOT).split(","))
                .anyMatch(each -> each.strip().equals(token.toLowerCase(Locale.ROOT)));
    }

    /** The target without its query. */
    String path() {
        return target.split("\\?", 2)[0];
    }
}
