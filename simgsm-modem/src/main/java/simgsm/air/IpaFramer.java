package simgsm.air;

import java.nio.ByteBuffer;
import java.util.Optional;

/** Cuts a stream of octets into IPA frames; one framer a connection. */
public final class IpaFramer {
    public IpaFramer() {}

    /** The frame as it goes on the wire. */
    public static byte[] encode(IpaFrame frame) {
        throw new UnsupportedOperationException();
    }

    /** Takes all octets that the buffer holds. */
    public void accept(ByteBuffer octets) {
        throw new UnsupportedOperationException();
    }

    /**
     * The next whole frame, if one has arrived.
     *
     * @throws ProtocolViolation for a frame longer than {@link IpaFrame#MAX_PAYLOAD}: the connection is beyond repair
     */
    public Optional<IpaFrame> next() throws ProtocolViolation {
        throw new UnsupportedOperationException();
    }
}
