package simgsm.console;

/** The command line is wrong; the text names the option, what it was given and what it expects. */
public final class UsageException extends Exception {
    public UsageException(String text) {
        super(text);
    }
}
