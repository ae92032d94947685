package simgsm.console;

/**
 * A console command that failed; the text, printed as {@code error text=}, names the cause and the expected input.
 */
public final class CommandException extends Exception {
    public CommandException(String text) {
        super(text);
    }
}
