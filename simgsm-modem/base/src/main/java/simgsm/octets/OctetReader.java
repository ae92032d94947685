package simgsm.octets;

import java.nio.charset.StandardCharsets;
import java.util.function.Function;

/**
 * Reads octets in order; numbers have their highest octet first. A read past the end throws the codec's own
 * exception, never an index error.
 *
 * <p>{@code what} names the field in the exception's text.
 *
 * @param <X> thrown when fewer octets are left than a field needs
 */
public class OctetReader<X extends Exception> {
    private final byte[] octets;
    private final int end;
    private final Function<String, X> error;
    private int position;

    /** A reader of all the octets; {@code error} makes the exception from its text. */
    public OctetReader(byte[] octets, Function<String, X> error) {
        this(octets, 0, octets.length, error);
    }

    /** A reader of the octets from index {@code from} to before {@code to}. */
    public OctetReader(byte[] octets, int from, int to, Function<String, X> error) {
        this.octets = octets;
        this.position = from;
        this.end = to;
        this.error = error;
    }

    /** A reader of the next {@code count} octets of another, which skips them. */
    protected OctetReader(OctetReader<X> whole, int count, String what) throws X {
        this(whole.octets, whole.take(count, what), whole.position, whole.error);
    }

    /** True if any octet is left. */
    public final boolean hasMore() {
        return position < end;
    }

    /** The number of octets left. */
    public final int remaining() {
        return end - position;
    }

    /** The index of the next octet among all octets, also in a reader of a part of them. */
    public final int position() {
        return position;
    }

    /** The next octet, 0 to 255. */
    public final int octet(String what) throws X {
        return octets[take(1, what)] & 0xff;
    }

    /** The next octet without moving on; only when {@link #hasMore}. */
    public final int peek() {
        return octets[position] & 0xff;
    }

    /** The next two octets as a number, 0 to 65535. */
    public final int twoOctets(String what) throws X {
        return (int) number(2, what);
    }

    /** The next four octets as an unsigned number of 32 bits. */
    public final long fourOctets(String what) throws X {
        return number(4, what);
    }

    /** The next eight octets as a number. */
    public final long eightOctets(String what) throws X {
        return number(8, what);
    }

    private long number(int count, String what) throws X {
        long value = 0;
        for (int i = take(count, what); i < position; i++) {
            value = value << 8 | octets[i] & 0xff;
        }
        return value;
    }

    /** The next eight octets as a number in IEEE 754 binary64. */
    public final double real() throws X {
        return Double.longBitsToDouble(eightOctets("a number"));
    }

    /** An unsigned number of 64 bits in LEB128: seven bits an octet, the lowest first, the top bit set but in the last. */
    public final long compact() throws X {
        long value = 0;
        for (int shift = 0; shift < Long.SIZE; shift += 7) {
            int octet = octet("a number");
            value |= (long) (octet & 0x7f) << shift;
            if (octet < 0x80) {
                return value;
            }
        }
        throw error.apply("a number has over 10 octets");
    }

    /** A number of items in LEB128; each item has one octet or more. */
    public final int count() throws X {
        long count = compact();
        if (count < 0 || count > remaining()) {
            throw error.apply("a list counts " + count + " items, " + remaining() + " octets are left");
        }
        return (int) count;
    }

    /** A text in UTF-8, led by its number of octets in LEB128. */
    public final String text() throws X {
        int length = count();
        return new String(octets, take(length, "a text"), length, StandardCharsets.UTF_8);
    }

    /** The next {@code count} octets. */
    public final OctetString string(int count, String what) throws X {
        return OctetString.adopting(bytes(count, what));
    }

    /** All octets that are left. */
    public final OctetString rest() {
        byte[] copy = Octets.range(octets, position, end);
        position = end;
        return OctetString.adopting(copy);
    }

    /** A copy of the next {@code count} octets. */
    public final byte[] bytes(int count, String what) throws X {
        int start = take(count, what);
        return Octets.range(octets, start, position);
    }

    /** Leaves the rest unread. */
    public final void skipRest() {
        position = end;
    }

    /** Moves on; returns the index of the first octet taken. */
    private int take(int count, String what) throws X {
        if (count > end - position) {
            throw error.apply(what + " needs " + count + " octets, " + (end - position) + " are left");
        }
        position += count;
        return position - count;
    }
}
