package simgsm.console;

/** What the run needs is not there, such as a display; the text says what would do instead. */
public final class UnavailableException extends Exception {
    public UnavailableException(String text) {
        super(text);
    }
}
