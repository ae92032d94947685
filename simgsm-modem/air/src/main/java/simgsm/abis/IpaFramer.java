package simgsm.abis;

import java.nio.ByteBuffer;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.ProtocolViolation;
import simgsm.octets.Octets;

/**
 * Splits a stream of octets into IPA frames; one framer per connection. If {@link #next} is called until it is empty
 * after each {@link #accept}, less than one frame is buffered, and each octet is copied twice at most.
 */
public final class IpaFramer {
    private static final int INITIAL_CAPACITY = 4096;

    private byte[] octets = new byte[INITIAL_CAPACITY];
    private int start;
    private int end;

    /** A framer for a new connection. */
    public IpaFramer() {}

    /** The frame on the wire. */
    public static byte[] encode(IpaFrame frame) {
        byte[] payload = frame.payload();
        return ByteBuffer.allocate(IpaFrame.HEADER_LENGTH + payload.length)
                .putShort((short) payload.length)
                .put((byte) frame.stream())
                .put(payload)
                .array();
    }

    /** Takes all octets of the buffer. */
    public void accept(ByteBuffer source) {
        int count = source.remaining();
        makeRoomFor(count);
        source.get(octets, end, count);
        end += count;
    }

    /**
     * The next whole frame, if one has arrived.
     *
     * @throws ProtocolViolation for a frame longer than {@link IpaFrame#MAX_PAYLOAD}, and at every further call: the
     *     connection must be closed
     */
    public Optional<IpaFrame> next() throws ProtocolViolation {
        int available = end - start;
        if (available < IpaFrame.HEADER_LENGTH) {
            return Optional.empty();
        }
        int length = (octets[start] & 0xff) << 8 | octets[start + 1] & 0xff;
        if (length > IpaFrame.MAX_PAYLOAD) {
            throw new ProtocolViolation(
                    Cause.PROTOCOL_ERROR,
                    "an IPA frame of " + length + " octets, at most " + IpaFrame.MAX_PAYLOAD + " are allowed");
        }
        if (available < IpaFrame.HEADER_LENGTH + length) {
            return Optional.empty();
        }
        int stream = octets[start + 2] & 0xff;
        int from = start + IpaFrame.HEADER_LENGTH;
        start = from + length;
        return Optional.of(new IpaFrame(stream, Octets.range(octets, from, start)));
    }

    private void makeRoomFor(int count) {
        int kept = end - start;
        if (start == end || end + count > octets.length) {
            byte[] target = capacityFor(kept + count);
            System.arraycopy(octets, start, target, 0, kept);
            octets = target;
            start = 0;
            end = kept;
        }
    }

    /** The current array, a longer one if it is too short, or one of the initial capacity after a burst. */
    private byte[] capacityFor(int needed) {
        if (needed > octets.length) {
            return new byte[Math.max(needed, octets.length * 2)];
        }
        boolean burstOver = octets.length > INITIAL_CAPACITY && needed <= INITIAL_CAPACITY / 4;
        return burstOver ? new byte[INITIAL_CAPACITY] : octets;
    }
}
