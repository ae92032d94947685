package simgsm.web;

/** A request that is answered with an error status. */
public final class RequestException extends Exception {
    private static final int MOST_QUOTED = 200;

    private final int status;

    public RequestException(int status, String text) {
        super(text);
        this.status = status;
    }

    /** Nothing is at a path. @param expected possible paths */
    public static RequestException notFound(String path, String expected) {
        return new RequestException(WebResponse.NOT_FOUND, "nothing at " + shortened(path) + ", expected " + expected);
    }

    /** Limits the part of a request that an error repeats. */
    public static String shortened(String text) {
        return text.length() <= MOST_QUOTED ? text : text.substring(0, MOST_QUOTED) + "...";
    }

    public int status() {
        return status;
    }

    WebResponse answer() {
        return WebResponse.error(status, getMessage());
    }
}
