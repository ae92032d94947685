package simgsm.console;

/** A console command that cannot be done; the text, shown as {@code error text=}, says why and what was expected. */
public final class CommandException extends Exception {
    public CommandException(String text) {
        super(text);
    }
}
