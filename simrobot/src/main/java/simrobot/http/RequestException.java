package simrobot.http;

/** A request that is answered with an error status. */
final class RequestException extends Exception {
    private final int status;

    RequestException(int status, String text) {
        super(text);
        this.status = status;
    }

    WebResponse answer() {
        return WebResponse.error(status, getMessage());
    }
}
