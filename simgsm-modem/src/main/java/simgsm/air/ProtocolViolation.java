package simgsm.air;

/** A received message or frame that breaks its standard; the text says what was wrong and what was expected. */
public final class ProtocolViolation extends Exception {
    private final Cause cause;

    /** @param cause what a STATUS message answers: 96 invalid mandatory information, 97 message type non-existent, ... */
    public ProtocolViolation(Cause cause, String text) {
        super(text);
        this.cause = cause;
    }

    public Cause statusCause() {
        return cause;
    }
}
