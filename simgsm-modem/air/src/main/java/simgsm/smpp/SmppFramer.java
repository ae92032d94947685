package simgsm.smpp;

import java.nio.ByteBuffer;
import java.util.Arrays;

/** Splits a stream of octets into PDUs. */
public final class SmppFramer {
    /** Maximum length: the longest message_payload and all other fields. */
    static final int MAX_PDU = 70_000;

    private static final int INITIAL_CAPACITY = 1_024;

    private byte[] octets = new byte[INITIAL_CAPACITY];
    private int start;
    private int end;

    /** Without octets. */
    public SmppFramer() {}

    public void accept(ByteBuffer more) {
        if (start > 0) {
            System.arraycopy(octets, start, octets, 0, end - start);
            end -= start;
            start = 0;
        }
        if (end + more.remaining() > octets.length) {
            octets = Arrays.copyOf(octets, Math.max(2 * octets.length, end + more.remaining()));
        }
        int count = more.remaining();
        more.get(octets, end, count);
        end += count;
    }

    /**
     * True if a complete PDU has arrived.
     *
     * @throws SmppViolation for a wrong command_length; the stream is unusable then
     */
    public boolean hasNext() throws SmppViolation {
        if (end - start < SmppCodec.HEADER_LENGTH) {
            if (end - start >= 4) {
                checkLength();
            }
            return false;
        }
        checkLength();
        return end - start >= length();
    }

    /** The next PDU; requires {@link #hasNext}. */
    public SmppPdu next() throws SmppViolation {
        int from = start;
        start += length();
        return SmppCodec.decode(octets, from, start);
    }

    private void checkLength() throws SmppViolation {
        int length = length();
        if (length < SmppCodec.HEADER_LENGTH || length > MAX_PDU) {
            int sequence = end - start >= SmppCodec.HEADER_LENGTH ? number(start + 12) : 0;
            throw new SmppViolation(
                            SmppStatus.INVALID_COMMAND_LENGTH,
                            "a PDU of " + Integer.toUnsignedString(length) + " octets, expected 16 to " + MAX_PDU)
                    .answeredBy(new SmppPdu.GenericNack(SmppStatus.INVALID_COMMAND_LENGTH, sequence));
        }
    }

    private int length() {
        return number(start);
    }

    private int number(int at) {
        return (octets[at] & 0xff) << 24
                | (octets[at + 1] & 0xff) << 16
                | (octets[at + 2] & 0xff) << 8
                | octets[at + 3] & 0xff;
    }
}
