package simgsm.web;

/** A request that is answered with an error status. */
public final class RequestException extends Exception {
    private final int status;

    public RequestException(int status, String text) {
        super(text);
        this.status = status;
    }

    /** Nothing is at a path. @param expected what could be there */
    public static RequestException notFound(String path, String expected) {
        return new RequestException(WebResponse.NOT_FOUND, "nothing at " + path + ", expected " + expected);
    }

    WebResponse answer() {
        return WebResponse.error(status, getMessage());
    }
}
