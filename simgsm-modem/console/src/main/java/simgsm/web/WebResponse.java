package simgsm.web;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/**
 * Status, header fields and body of a response.
 *
 * @param fields without those that all responses have
 * @param octets not copied, so it must not change
 * @param stream what follows instead of octets, until the connection ends; null if there is none
 */
public record WebResponse(int status, Map<String, String> fields, byte[] octets, Stream stream) {
    public static final int OK = 200;
    public static final int NOT_MODIFIED = 304;
    public static final int BAD_REQUEST = 400;
    public static final int FORBIDDEN = 403;
    public static final int NOT_FOUND = 404;
    public static final int METHOD_NOT_ALLOWED = 405;
    public static final int URI_TOO_LONG = 414;
    public static final int FIELDS_TOO_LARGE = 431;
    public static final int FAULT = 500;
    public static final int UNAVAILABLE = 503;
    public static final int VERSION_NOT_SUPPORTED = 505;

    /** The phrases of RFC 9110, 15, and RFC 6585, 5. */
    private static final Map<Integer, String> PHRASES = Map.ofEntries(
            Map.entry(OK, "OK"),
            Map.entry(NOT_MODIFIED, "Not Modified"),
            Map.entry(BAD_REQUEST, "Bad Request"),
            Map.entry(FORBIDDEN, "Forbidden"),
            Map.entry(NOT_FOUND, "Not Found"),
            Map.entry(METHOD_NOT_ALLOWED, "Method Not Allowed"),
            Map.entry(URI_TOO_LONG, "URI Too Long"),
            Map.entry(FIELDS_TOO_LARGE, "Request Header Fields Too Large"),
            Map.entry(FAULT, "Internal Server Error"),
            Map.entry(UNAVAILABLE, "Service Unavailable"),
            Map.entry(VERSION_NOT_SUPPORTED, "HTTP Version Not Supported"));

    /** A body of unknown length, written on the connection's own thread. */
    public interface Stream extends AutoCloseable {
        void writeTo(OutputStream out) throws IOException, InterruptedException;

        /** Called once at the end, also if nothing was written. */
        @Override
        void close();
    }

    private static WebResponse of(int status, String type, byte[] octets) {
        return new WebResponse(status, Map.of("Content-Type", type), octets, null);
    }

    public static WebResponse json(String json) {
        return text("application/json", json);
    }

    public static WebResponse html(String html) {
        return text("text/html; charset=utf-8", html);
    }

    public static WebResponse jpeg(byte[] jpeg) {
        return of(OK, "image/jpeg", jpeg);
    }

    /** A text of any type, in UTF-8. */
    public static WebResponse text(String type, String text) {
        return of(OK, type, text.getBytes(StandardCharsets.UTF_8));
    }

    /** A body that ends with the connection. */
    public static WebResponse stream(String type, Stream stream) {
        return new WebResponse(OK, Map.of("Content-Type", type), new byte[0], stream);
    }

    /** A page in octets. */
    static WebResponse page(int status, byte[] octets) {
        return of(status, "text/html; charset=utf-8", octets);
    }

    /** An error with its reason as JSON. */
    public static WebResponse error(int status, String text) {
        String json =
                new JsonText().open('{').name("error").value(text).close('}').toString();
        return of(status, "application/json", json.getBytes(StandardCharsets.UTF_8));
    }

    /** The same with a further header field. */
    public WebResponse with(String name, String value) {
        Map<String, String> more = new HashMap<>(fields);
        more.put(name, value);
        return new WebResponse(status, more, octets, stream);
    }

    String statusLine() {
        return "HTTP/1.1 " + status + " " + PHRASES.get(status);
    }
}
