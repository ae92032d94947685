package simgsm.air;

import java.util.Arrays;

/**
 * Reads octets in order and refuses to read past the end: every short message ends in a {@link ProtocolViolation} with
 * cause 96, never in an array index error.
 */
public final class OctetReader {
    private final byte[] octets;
    private final int end;
    private int position;

    public OctetReader(byte[] octets) {
        this(octets, 0, octets.length);
    }

    private OctetReader(byte[] octets, int from, int to) {
        this.octets = octets;
        this.position = from;
        this.end = to;
    }

    public boolean hasMore() {
        return position < end;
    }

    public int remaining() {
        return end - position;
    }

    /** The next octet, 0 to 255; {@code what} names it in the refusal. */
    public int octet(String what) throws ProtocolViolation {
        require(1, what);
        return octets[position++] & 0xff;
    }

    /** The next octet without moving on; only when {@link #hasMore}. */
    public int peek() {
        return octets[position] & 0xff;
    }

    /** Two octets, the higher first. */
    public int twoOctets(String what) throws ProtocolViolation {
        require(2, what);
        int value = (octets[position] & 0xff) << 8 | octets[position + 1] & 0xff;
        position += 2;
        return value;
    }

    /** Four octets, the highest first, as unsigned 32 bits. */
    public long fourOctets(String what) throws ProtocolViolation {
        return (long) twoOctets(what) << 16 | twoOctets(what);
    }

    /** A reader of the next {@code count} octets, which this reader leaves behind. */
    public OctetReader part(int count, String what) throws ProtocolViolation {
        require(count, what);
        position += count;
        return new OctetReader(octets, position - count, position);
    }

    /** A reader of a value that is led by its length in one octet (LV). */
    public OctetReader lengthAndValue(String what) throws ProtocolViolation {
        return part(octet(what), what);
    }

    public OctetString string(int count, String what) throws ProtocolViolation {
        return OctetString.adopting(bytes(count, what));
    }

    /** All that is left. */
    public OctetString rest() {
        byte[] copy = Arrays.copyOfRange(octets, position, end);
        position = end;
        return OctetString.adopting(copy);
    }

    /** A copy of the next {@code count} octets. */
    public byte[] bytes(int count, String what) throws ProtocolViolation {
        require(count, what);
        position += count;
        return Arrays.copyOfRange(octets, position - count, position);
    }

    /** Leaves the rest unread. */
    public void skipRest() {
        position = end;
    }

    private void require(int count, String what) throws ProtocolViolation {
        if (count > end - position) {
            throw new ProtocolViolation(
                    Cause.INVALID_MANDATORY_INFORMATION,
                    what + " needs " + count + " octets, " + (end - position) + " are left");
        }
    }
}
