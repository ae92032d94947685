package simrobot.http;

import java.nio.charset.StandardCharsets;

/** Status, content type and body of a response. */
record WebResponse(int status, String type, byte[] body) {
    static final int OK = 200;
    static final int BAD_REQUEST = 400;
    static final int NOT_FOUND = 404;
    static final int METHOD_NOT_ALLOWED = 405;
    static final int UNAVAILABLE = 503;

    static WebResponse json(String json) {
        return new WebResponse(OK, "application/json", json.getBytes(StandardCharsets.UTF_8));
    }

    static WebResponse html(String html) {
        return new WebResponse(OK, "text/html; charset=utf-8", html.getBytes(StandardCharsets.UTF_8));
    }

    static WebResponse jpeg(byte[] jpeg) {
        return new WebResponse(OK, "image/jpeg", jpeg);
    }

    static WebResponse error(int status, String text) {
        return new WebResponse(
                status, "application/json", StatusJson.error(text).getBytes(StandardCharsets.UTF_8));
    }
}
