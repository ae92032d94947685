package simgsm.air;

/** Layer-3 messages to octets and back (TS 24.008, TS 24.011, TS 44.018). Knows no socket and keeps no state. */
public final class Layer3Codec {
    private Layer3Codec() {}

    /**
     * The octets of a message.
     *
     * @param sendSequence N(SD), 0 or 1, set in uplink mobility management and call control messages and ignored in all
     *     others (TS 24.007, 11.2.3.2.3)
     */
    public static byte[] encode(Layer3Message message, Direction direction, int sendSequence) {
        throw new UnsupportedOperationException();
    }

    /**
     * The message in these octets; an uplink message's N(SD) is masked out, see {@link #sendSequence}.
     *
     * @throws ProtocolViolation for anything that the standard does not allow, with the cause for a STATUS answer
     */
    public static Layer3Message decode(byte[] octets, Direction direction) throws ProtocolViolation {
        throw new UnsupportedOperationException();
    }

    /** N(SD) of an uplink mobility management or call control message, 0 or 1; -1 for messages that carry none. */
    public static int sendSequence(byte[] octets) {
        throw new UnsupportedOperationException();
    }
}
