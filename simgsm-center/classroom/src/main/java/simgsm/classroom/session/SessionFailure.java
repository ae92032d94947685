package simgsm.classroom.session;

/** A line of a script that could not be performed, or an event that has not come; the text says what was expected. */
public final class SessionFailure extends Exception {
    public SessionFailure(String text) {
        super(text);
    }
}
