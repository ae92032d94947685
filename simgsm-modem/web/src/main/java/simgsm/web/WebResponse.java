package simgsm.web;

import java.nio.charset.StandardCharsets;

/**
 * Status, content type and body of a response.
 *
 * @param body not copied, so it must not change
 */
public record WebResponse(int status, String type, byte[] body) {
    public static final int OK = 200;
    public static final int NOT_MODIFIED = 304;
    public static final int BAD_REQUEST = 400;
    public static final int UNAUTHORIZED = 401;
    public static final int FORBIDDEN = 403;
    public static final int NOT_FOUND = 404;
    public static final int METHOD_NOT_ALLOWED = 405;
    public static final int CONTENT_TOO_LARGE = 413;
    public static final int UNSUPPORTED_TYPE = 415;
    public static final int UNPROCESSABLE = 422;
    public static final int TOO_MANY_REQUESTS = 429;
    public static final int UNAVAILABLE = 503;

    public static WebResponse json(String json) {
        return text("application/json", json);
    }

    public static WebResponse jpeg(byte[] jpeg) {
        return new WebResponse(OK, "image/jpeg", jpeg);
    }

    /** A text of any type, in UTF-8. */
    public static WebResponse text(String type, String text) {
        return new WebResponse(OK, type, text.getBytes(StandardCharsets.UTF_8));
    }

    /** An error with its reason as JSON. */
    public static WebResponse error(int status, String text) {
        String json =
                new JsonText().open('{').name("error").value(text).close('}').toString();
        return new WebResponse(status, "application/json", json.getBytes(StandardCharsets.UTF_8));
    }
}
