package simgsm.modem.at;

/** A command being performed. */
public final class AtRequest {
    /** Receives the text entered at a prompt. */
    @FunctionalInterface
    public interface TextReceiver {
        /** @param text octets as entered, without the final Ctrl-Z */
        AtResult take(byte[] text) throws AtException;
    }

    private final AtSession<?> session;
    private final AtCommand command;
    private boolean finished;

    AtRequest(AtSession<?> session, AtCommand command) {
        this.session = session;
        this.command = command;
    }

    public AtCommand command() {
        return command;
    }

    public AtParameters parameters() throws AtException {
        return AtParameters.of(command.parameters());
    }

    /** The number of a basic command, such as 1 in ATE1; 0 if there is none. */
    public int basicNumber(int most) throws AtException {
        return parameters().refusing(AtResult.ERROR).number(0, 0, most, 0);
    }

    /** Sends a line of information. */
    public void line(String text) {
        session.line(text);
    }

    /** Sends a line with the command's name and these values, separated by commas. */
    public void answer(Object... values) {
        StringBuilder text = new StringBuilder(command.name()).append(": ");
        for (int i = 0; i < values.length; i++) {
            text.append(i == 0 ? "" : ",").append(values[i]);
        }
        line(text.toString());
    }

    /** Sets the result of a pending command; a second result is ignored. */
    public void finish(AtResult result) {
        if (!finished && result != AtResult.PENDING) {
            finished = true;
            session.finished(this, result);
        }
    }

    /** True if the result was given, or the client has disconnected. */
    public boolean isOver() {
        return finished || !session.isPerforming(this);
    }

    /**
     * Sends the prompt and collects text up to Ctrl-Z; ESC ends the command with OK, and 60 s without a character
     * with ERROR.
     *
     * @param ofLines true if a carriage return begins a new line, with a new prompt; else it is ignored
     * @return PENDING
     */
    public AtResult prompt(boolean ofLines, TextReceiver receiver) {
        session.prompt(this, ofLines, receiver);
        return AtResult.PENDING;
    }

    /** A quoted text. */
    public static String quoted(String text) {
        return '"' + text + '"';
    }
}
