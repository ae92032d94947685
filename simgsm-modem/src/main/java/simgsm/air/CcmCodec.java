package simgsm.air;

/** Connection control messages to the payload of an {@link IpaFrame#CCM} frame and back. */
public final class CcmCodec {
    private CcmCodec() {}

    public static byte[] encode(CcmMessage message) {
        throw new UnsupportedOperationException();
    }

    public static CcmMessage decode(byte[] payload) throws ProtocolViolation {
        throw new UnsupportedOperationException();
    }
}
