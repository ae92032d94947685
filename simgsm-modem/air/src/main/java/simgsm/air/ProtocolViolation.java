package simgsm.air;

import java.util.Optional;

/**
 * A received message or frame that breaks its standard; the text says what was wrong and what was expected. It carries
 * what could be read of a layer-3 message, so that {@link ProtocolErrorAnswers} can answer it.
 *
 * <p>It has no stack trace: a peer may cause any number of these, and the trace would only show the codec.
 */
public final class ProtocolViolation extends Exception {
    private final Cause cause;
    private final transient Layer3Header header;

    /** @param cause what a STATUS message answers: 96 invalid mandatory information, 97 message type non-existent, ... */
    public ProtocolViolation(Cause cause, String text) {
        this(cause, text, null);
    }

    private ProtocolViolation(Cause cause, String text, Layer3Header header) {
        super(text, null, false, false);
        this.cause = cause;
        this.header = header;
    }

    public Cause statusCause() {
        return cause;
    }

    /** The header of the refused layer-3 message; empty if not even that could be read, or for other layers. */
    public Optional<Layer3Header> header() {
        return Optional.ofNullable(header);
    }

    /** The same violation, now known to be of this message; a header that is already there stays. */
    ProtocolViolation in(Layer3Header refused) {
        return header != null ? this : new ProtocolViolation(cause, refused.name() + ": " + getMessage(), refused);
    }
}
