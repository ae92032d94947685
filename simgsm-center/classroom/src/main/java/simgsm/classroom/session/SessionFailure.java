package simgsm.classroom.session;

/** A script's line that failed, or a missing event; the text names the expected one. */
public final class SessionFailure extends Exception {
    public SessionFailure(String text) {
        super(text);
    }
}
