package simgsm.web;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.Map;
import java.util.Optional;

/** The opening handshake of a WebSocket server (RFC 6455, 4.2). */
final class WebSocketHandshake {
    private static final String GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
    private static final String VERSION = "13";
    private static final int KEY_OCTETS = 16;
    private static final int UPGRADE_REQUIRED = 426;

    private WebSocketHandshake() {}

    /** True if a request asks for a WebSocket; all others are for the pages. */
    static boolean isAsked(HttpHead head) {
        return head.contains("Upgrade", "websocket");
    }

    /** @throws RequestException if the answer is not 101 */
    static WebSocketPath path(HttpHead head, Map<String, WebSocketPath> paths) throws RequestException {
        if (!head.method().equals("GET")) {
            throw new RequestException(
                    WebResponse.METHOD_NOT_ALLOWED, "method " + head.method() + " is not allowed, expected GET");
        }
        if (!head.version().equals("HTTP/1.1")
                || !head.contains("Connection", "upgrade")
                || head.field("Host").isEmpty()
                || !hasKey(head)) {
            throw new RequestException(
                    WebResponse.BAD_REQUEST,
                    "malformed WebSocket handshake, expected HTTP/1.1, Host, Connection: Upgrade and a Sec-WebSocket-Key of 16 octets");
        }
        if (!head.field("Sec-WebSocket-Version").equals(Optional.of(VERSION))) {
            throw new RequestException(UPGRADE_REQUIRED, "expected Sec-WebSocket-Version: " + VERSION);
        }
        WebSocketPath path = paths.get(head.path());
        if (path == null) {
            throw RequestException.notFound(head.path(), "a WebSocket at " + String.join(", ", paths.keySet()));
        }
        return path;
    }

    private static boolean hasKey(HttpHead head) {
        try {
            return Base64.getDecoder().decode(head.field("Sec-WebSocket-Key").orElse("")).length == KEY_OCTETS;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    /** The answer with status 101. No extension is accepted, so frames are not compressed. */
    static byte[] answer(HttpHead head, WebSocketPath path) {
        String protocol = !path.protocol().isEmpty() && head.contains("Sec-WebSocket-Protocol", path.protocol())
                ? "Sec-WebSocket-Protocol: " + path.protocol() + "\r\n"
                : "";
        return ("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: "
                        + accept(head.field("Sec-WebSocket-Key").orElseThrow()) + "\r\n" + protocol + "\r\n")
                .getBytes(StandardCharsets.US_ASCII);
    }

    static String accept(String key) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-1").digest((key + GUID).getBytes(StandardCharsets.US_ASCII));
            return Base64.getEncoder().encodeToString(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java platform has SHA-1", e);
        }
    }

    /** An answer that closes the connection. */
    static byte[] refusal(RequestException refusal) {
        WebResponse answer = refusal.answer();
        String version = answer.status() == UPGRADE_REQUIRED
                ? "Sec-WebSocket-Version: " + VERSION + "\r\nUpgrade: websocket\r\n"
                : "";
        String allow = answer.status() == WebResponse.METHOD_NOT_ALLOWED ? "Allow: GET\r\n" : "";
        String body = new String(answer.body(), StandardCharsets.UTF_8);
        return ("HTTP/1.1 " + answer.status() + " Refused\r\n" + version + allow + "Content-Type: " + answer.type()
                        + "\r\nContent-Length: " + answer.body().length + "\r\nConnection: close\r\n\r\n" + body)
                .getBytes(StandardCharsets.UTF_8);
    }
}
