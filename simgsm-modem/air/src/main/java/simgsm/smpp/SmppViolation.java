package simgsm.smpp;

import java.util.Optional;

/** A PDU that violates the protocol, with its response. Without a stack trace, because peers cause any number of them. */
public final class SmppViolation extends Exception {
    private final int status;

    /** Set by the decoder, which has the header. */
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

    /** The response; empty if none is due, as for an invalid response. */
    public Optional<SmppPdu> answer() {
        return Optional.ofNullable(answer);
    }
}
