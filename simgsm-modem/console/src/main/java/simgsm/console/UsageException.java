package simgsm.console;

/** An invalid command line; the text names the option, its value and the expected one. */
public final class UsageException extends Exception {
    public UsageException(String text) {
        super(text);
    }
}
