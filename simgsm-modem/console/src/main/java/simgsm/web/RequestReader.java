package simgsm.web;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the heads of requests (RFC 9112, 2.1) from a connection. */
final class RequestReader {
    /** Of a request line, and of all header fields together. */
    static final int MOST_OCTETS = 65_536;

    private static final String TOKEN = "[!#$%&'*+.^_`|~0-9A-Za-z-]+";
    private static final Pattern REQUEST_LINE =
            Pattern.compile("(?<method>" + TOKEN + ") +(?<target>[!-~]+) +HTTP/(?<major>[0-9])\\.(?<minor>[0-9])");
    private static final Pattern FIELD = Pattern.compile("(" + TOKEN + "):[ \\t]*([^\\x00-\\x08\\x0a-\\x1f\\x7f]*)");
    /** A path, after the host's address in requests to a proxy (RFC 9112, 3.2.2). */
    private static final Pattern TARGET =
            Pattern.compile("(https?://(?<host>[^/?#]*))?(?<path>/[^?#]*|(?<=[^/])(?=\\?|$))(\\?(?<query>[^#]*))?");

    private final InputStream in;

    RequestReader(InputStream in) {
        this.in = in;
    }

    /**
     * The next request.
     *
     * @throws EOFException if the connection has ended
     * @throws RequestException if it is none, or too long
     */
    WebRequest next() throws IOException, RequestException {
        String first = line(MOST_OCTETS, WebResponse.URI_TOO_LONG, "request line");
        if (first.isEmpty()) {
            // RFC 9112, 2.2: an empty line before a request is ignored
            first = line(MOST_OCTETS, WebResponse.URI_TOO_LONG, "request line");
        }
        Matcher line = REQUEST_LINE.matcher(first);
        if (!line.matches()) {
            throw malformed("request line " + RequestException.shortened(first), "METHOD PATH HTTP/1.1");
        }
        if (!line.group("major").equals("1")) {
            throw new RequestException(WebResponse.VERSION_NOT_SUPPORTED, "expected HTTP/1.1");
        }
        Matcher target = TARGET.matcher(line.group("target"));
        // OPTIONS may ask about the server, by * (RFC 9112, 3.2.4)
        boolean isPath = target.matches();
        if (!isPath && !line.group("target").equals("*")) {
            throw malformed("path " + RequestException.shortened(line.group("target")), "/...");
        }
        Map<String, String> fields = fields();
        if (isPath && target.group("host") != null) {
            fields.put("host", target.group("host"));
        }
        boolean isPersistent = !line.group("minor").equals("0")
                && !fields.getOrDefault("connection", "")
                        .toLowerCase(Locale.ROOT)
                        .contains("close");
        String path = isPath ? target.group("path") : "*";
        String query = isPath && target.group("query") != null ? target.group("query") : "";
        return new WebRequest(line.group("method"), path, query, isPersistent, Map.copyOf(fields));
    }

    private Map<String, String> fields() throws IOException, RequestException {
        Map<String, String> fields = new HashMap<>();
        int left = MOST_OCTETS;
        while (true) {
            String text = line(left, WebResponse.FIELDS_TOO_LARGE, "header");
            if (text.isEmpty()) {
                return fields;
            }
            left -= text.length();
            Matcher field = FIELD.matcher(text);
            if (!field.matches()) {
                throw malformed("header field " + RequestException.shortened(text), "Name: value");
            }
            fields.merge(
                    field.group(1).toLowerCase(Locale.ROOT),
                    field.group(2).stripTrailing(),
                    (one, other) -> one + ", " + other);
        }
    }

    private static RequestException malformed(String what, String expected) {
        return new RequestException(WebResponse.BAD_REQUEST, "malformed " + what + ", expected " + expected);
    }

    /** Up to the next end of a line, CR LF or LF alone. */
    private String line(int most, int status, String what) throws IOException, RequestException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        for (int octet = in.read(); octet != '\n'; octet = in.read()) {
            if (octet < 0) {
                throw new EOFException("the connection has ended");
            }
            if (octets.size() == most) {
                throw new RequestException(
                        status, "the " + what + " is too long, expected at most " + MOST_OCTETS + " octets");
            }
            octets.write(octet);
        }
        String line = octets.toString(StandardCharsets.ISO_8859_1);
        return line.endsWith("\r") ? line.substring(0, line.length() - 1) : line;
    }
}
