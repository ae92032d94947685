package simgsm.center.smpp;

import java.util.Optional;

/**
 * A PDU that breaks the protocol, with the answer that it gets. Without a stack trace: a peer may cause any number of
 * these.
 */
public final class SmppViolation extends Exception {
    private final int status;

    /** Filled in by the decoder, which knows the header. */
    private transient SmppPdu answer;

    /** @param status one of {@link SmppStatus} */
    public SmppViolation(int status, String text) {
        super(text, null, false, false);
        this.status = status;
    }

    public int status() {
        return status;
    }

    SmppViolation answeredBy(SmppPdu pdu) {
        answer = pdu;
        return this;
    }

    /** Empty where nothing must be answered, as to a broken answer. */
    Optional<SmppPdu> answer() {
        return Optional.ofNullable(answer);
    }
}
