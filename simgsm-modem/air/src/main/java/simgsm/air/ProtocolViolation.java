package simgsm.air;

import java.util.Optional;

/**
 * A received message or frame that breaks its standard; the text names the fault and the expected form. Contains the
 * readable header of a layer-3 message, for {@code ProtocolErrorAnswers}.
 *
 * <p>It has no stack trace: a peer may cause any number of violations, and the trace would only show the codec.
 */
public final class ProtocolViolation extends Exception {
    private final Cause cause;
    private final transient Layer3Header header;
    /** RP message reference of a broken RP message; null elsewhere. */
    private final Integer relayReference;

    /** @param cause for a STATUS answer: 96 invalid mandatory information, 97 message type non-existent, ... */
    public ProtocolViolation(Cause cause, String text) {
        this(cause, text, null, null);
    }

    private ProtocolViolation(Cause cause, String text, Layer3Header header, Integer relayReference) {
        super(text, null, false, false);
        this.cause = cause;
        this.header = header;
        this.relayReference = relayReference;
    }

    /** A violation with cause 96, invalid mandatory information. */
    public static ProtocolViolation invalid(String text) {
        return new ProtocolViolation(Cause.INVALID_MANDATORY_INFORMATION, text);
    }

    /** The cause for a STATUS answer. */
    public Cause statusCause() {
        return cause;
    }

    /** The header of the refused layer-3 message; empty if unreadable, or for other layers. */
    public Optional<Layer3Header> header() {
        return Optional.ofNullable(header);
    }

    /** A copy for an RP message with this reference. */
    ProtocolViolation inRelay(int reference) {
        return new ProtocolViolation(cause, getMessage(), null, reference);
    }

    /** A copy with the header of its message. */
    ProtocolViolation in(Layer3Header refused) {
        return new ProtocolViolation(
                cause, refused.name() + ": " + getMessage(), refused.withRelayReference(relayReference), null);
    }
}
