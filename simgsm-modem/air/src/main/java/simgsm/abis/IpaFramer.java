package simgsm.abis;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.ProtocolViolation;

/**
 * Cuts a stream of octets into IPA frames; one framer a connection. Call {@link #next} until it is empty after each
 * {@link #accept}: then less than one frame is ever left over, and each octet is copied twice at most.
 */
public final class IpaFramer {
    private static final int INITIAL_CAPACITY = 4096;

    private byte[] octets = new byte[INITIAL_CAPACITY];
    private int start;
    private int end;

    /** For a connection from which nothing has come yet. */
    public IpaFramer() {}

    /** The frame as it goes on the wire. */
    public static byte[] encode(IpaFrame frame) {
        byte[] payload = frame.payload();
        byte[] wire = new byte[IpaFrame.HEADER_LENGTH + payload.length];
        wire[0] = (byte) (payload.length >> 8);
        wire[1] = (byte) payload.length;
        wire[2] = (byte) frame.stream();
        System.arraycopy(payload, 0, wire, IpaFrame.HEADER_LENGTH, payload.length);
        return wire;
    }

    /** Takes all octets that the buffer holds. */
    public void accept(ByteBuffer source) {
        int count = source.remaining();
        makeRoomFor(count);
        source.get(octets, end, count);
        end += count;
    }

    /**
     * The next whole frame, if one has arrived.
     *
     * @throws ProtocolViolation for a frame longer than {@link IpaFrame#MAX_PAYLOAD}: the connection is beyond repair,
     *     and every further call says so again
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
        return Optional.of(new IpaFrame(stream, Arrays.copyOfRange(octets, from, start)));
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

    /** The present array, a longer one if that is too short, or the small one again once a burst has passed. */
    private byte[] capacityFor(int needed) {
        if (needed > octets.length) {
            return new byte[Math.max(needed, octets.length * 2)];
        }
        boolean burstOver = octets.length > INITIAL_CAPACITY && needed <= INITIAL_CAPACITY / 4;
        return burstOver ? new byte[INITIAL_CAPACITY] : octets;
    }
}
