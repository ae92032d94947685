package simrobot.http;

/** A request that cannot be met. */
final class RefusedException extends Exception {
    private final int status;

    RefusedException(int status, String text) {
        super(text);
        this.status = status;
    }

    Answer answer() {
        return Answer.error(status, getMessage());
    }
}
