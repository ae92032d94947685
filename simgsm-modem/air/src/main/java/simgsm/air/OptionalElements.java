package simgsm.air;

import java.util.Arrays;
import java.util.Optional;

/**
 * Walks the optional elements at the end of a message and skips those that are not known (TS 24.007, 11.2.4):
 *
 * <pre>
 *   1xxx....   one octet, value inside          skipped when unknown
 *   0000xxxx   identifier, length, value        refused when unknown: it must be understood
 *   0xxxxxxx   identifier, length, value        skipped when unknown
 * </pre>
 *
 * Elements of a fixed length have no length octet, so the walk has to know all that a protocol may send. A truncated
 * optional element counts as absent (TS 24.008, 8.7.1).
 */
public final class OptionalElements {
    private final MessageReader in;
    private final int[] understood;
    private final FixedElements fixed;
    private MessageReader value;

    /** Lengths of the elements without length octet, by identifier; 0 for all others. */
    public enum FixedElements {
        NONE,
        /** Local time zone 1 octet, universal time and zone 7 octets. */
        MOBILITY_MANAGEMENT(0x46, 1, 0x47, 7),
        /** Signal and keypad facility, 1 octet each. */
        CALL_CONTROL(0x34, 1, 0x2c, 1),
        /** Channel mode 1 octet. */
        RADIO_RESOURCE(0x63, 1);

        private final int[] lengths = new int[128];

        FixedElements(int... identifiersAndLengths) {
            for (int i = 0; i < identifiersAndLengths.length; i += 2) {
                lengths[identifiersAndLengths[i]] = identifiersAndLengths[i + 1];
            }
        }
    }

    /** @param understood identifiers below 0x10 that are not refused */
    public OptionalElements(MessageReader in, FixedElements fixed, int... understood) {
        this.in = in;
        this.fixed = fixed;
        this.understood = understood;
    }

    /** The value of the next element with this identifier; the elements before it are skipped, those after it left. */
    public Optional<MessageReader> first(int wanted) throws ProtocolViolation {
        for (int identifier = next(); identifier >= 0; identifier = next()) {
            if (identifier == wanted) {
                return Optional.of(value);
            }
        }
        return Optional.empty();
    }

    /** Skips all elements. */
    void skipAll() throws ProtocolViolation {
        first(-1);
    }

    /** The next element's identifier, or -1 at the end. */
    int next() throws ProtocolViolation {
        while (in.hasMore()) {
            int identifier = in.octet("element identifier");
            if (identifier < 0x80) {
                return longElement(identifier);
            }
        }
        return -1;
    }

    /** The value of the element whose identifier {@link #next} returned last. */
    MessageReader value() {
        return value;
    }

    private int longElement(int identifier) throws ProtocolViolation {
        boolean known = isUnderstood(identifier);
        if (identifier < 0x10 && !known) {
            throw ProtocolViolation.invalid(
                    String.format("element 0x%02x must be understood and is not known here", identifier));
        }
        int length = fixed.lengths[identifier];
        if (length == 0) {
            length = in.hasMore() ? in.octet("element length") : 1;
        }
        if (length > in.remaining()) {
            in.skipRest();
            return -1;
        }
        value = in.part(length, "element");
        return identifier;
    }

    private boolean isUnderstood(int identifier) {
        return Arrays.stream(understood).anyMatch(each -> each == identifier);
    }
}
