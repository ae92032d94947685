package simrobot.http;

import java.nio.charset.StandardCharsets;

/** What is sent back. */
record Answer(int status, String type, byte[] body) {
    static final int OK = 200;
    static final int BAD_REQUEST = 400;
    static final int NOT_FOUND = 404;
    static final int METHOD_NOT_ALLOWED = 405;
    static final int UNAVAILABLE = 503;

    static Answer json(String json) {
        return new Answer(OK, "application/json", json.getBytes(StandardCharsets.UTF_8));
    }

    static Answer html(String html) {
        return new Answer(OK, "text/html; charset=utf-8", html.getBytes(StandardCharsets.UTF_8));
    }

    static Answer jpeg(byte[] jpeg) {
        return new Answer(OK, "image/jpeg", jpeg);
    }

    static Answer error(int status, String text) {
        return new Answer(status, "application/json", StatusJson.error(text).getBytes(StandardCharsets.UTF_8));
    }
}
