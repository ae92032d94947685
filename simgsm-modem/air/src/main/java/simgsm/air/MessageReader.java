package simgsm.air;

import simgsm.octets.OctetReader;
import simgsm.octets.OctetString;

/** Reads a message of the air interface; one that ends too early is a {@link ProtocolViolation} with cause 96. */
public final class MessageReader extends OctetReader<ProtocolViolation> {
    /** A reader of a whole message. */
    public MessageReader(byte[] octets) {
        super(octets, ProtocolViolation::invalid);
    }

    /** A reader of a whole message. */
    public MessageReader(OctetString octets) {
        this(octets.toArray());
    }

    private MessageReader(MessageReader whole, int count, String what) throws ProtocolViolation {
        super(whole, count, what);
    }

    /** A reader of the next {@code count} octets, skipped by this reader. */
    public MessageReader part(int count, String what) throws ProtocolViolation {
        return new MessageReader(this, count, what);
    }

    /** A reader of a value after its length in one octet (LV). */
    public MessageReader lengthAndValue(String what) throws ProtocolViolation {
        return part(octet(what), what);
    }
}
