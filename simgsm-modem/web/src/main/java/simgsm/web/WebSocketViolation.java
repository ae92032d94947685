package simgsm.web;

/** A breach of RFC 6455 by the client; its code closes the socket. */
final class WebSocketViolation extends Exception {
    static final int PROTOCOL_ERROR = 1002;
    static final int INVALID_TEXT = 1007;
    static final int TOO_BIG = 1009;

    private final int code;

    WebSocketViolation(int code, String text) {
        super(text);
        this.code = code;
    }

    int code() {
        return code;
    }
}
