package simgsm.air;

/** RSL messages to the payload of an {@link IpaFrame#RSL} frame and back. */
public final class RslCodec {
    private RslCodec() {}

    public static byte[] encode(RslMessage message) {
        throw new UnsupportedOperationException();
    }

    public static RslMessage decode(byte[] payload) throws ProtocolViolation {
        throw new UnsupportedOperationException();
    }
}
