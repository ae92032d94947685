package simgsm.console;

/** A requirement of the run is missing, such as a display; the text names the alternative. */
public final class UnavailableException extends Exception {
    public UnavailableException(String text) {
        super(text);
    }
}
