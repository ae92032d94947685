package simgsm.console;

/** A console command that failed; the text, printed as {@code error text=}, has the cause and what was expected. */
public final class CommandException extends Exception {
    public CommandException(String text) {
        super(text);
    }
}
