package simgsm.air;

import java.util.List;
import java.util.Locale;
import java.util.random.RandomGenerator;
import simgsm.octets.OctetString;

/**
 * An information element of a message: one row of the message's table as the standard prints it (TS 24.007, 11.2), and the
 * components of the message's record that hold its value.
 */
public final class Element {
    /** Mandatory, conditional or optional. */
    public enum Presence {
        M,
        C,
        O
    }

    /** Value, with identifier and length before it as the letters say; T has no value; HALF is a value of half an octet, "V 1/2". */
    public enum Format {
        HALF,
        V,
        LV,
        T,
        TV,
        TLV;

        boolean hasIdentifier() {
            return this == T || this == TV || this == TLV;
        }

        boolean hasLength() {
            return this == LV || this == TLV;
        }
    }

    private static final int NO_IDENTIFIER = -1;

    final int identifier;
    final Format format;
    /** The sent value of an element without a component; null if not sent. */
    OctetString sent;
    /** The component's value when the element is absent; null for that of the component's type. */
    Object absent;
    /** Indexes of the components in the record, set by the message's table. */
    int[] places;

    private final ElementType<?> type;
    private final Presence presence;
    private final int leastLength;
    private final int mostLength;
    private String name;
    private List<String> components = List.of();
    private Direction only;

    private Element(int identifier, ElementType<?> type, Presence presence, Format format, int least, int most) {
        this.identifier = identifier;
        this.type = type;
        this.presence = presence;
        this.format = format;
        leastLength = least;
        mostLength = most;
        name = type.title();
    }

    /** A row as the standard prints it. @param least length in octets, with identifier and length; so is {@code most} */
    static Element row(int identifier, ElementType<?> type, Presence presence, Format format, int least, int most) {
        return new Element(identifier, type, presence, format, least, most);
    }

    static Element row(int identifier, ElementType<?> type, Presence presence, Format format, int length) {
        return row(identifier, type, presence, format, length, length);
    }

    static Element row(ElementType<?> type, Presence presence, Format format, int least, int most) {
        return row(NO_IDENTIFIER, type, presence, format, least, most);
    }

    static Element row(ElementType<?> type, Presence presence, Format format, int length) {
        return row(NO_IDENTIFIER, type, presence, format, length, length);
    }

    /** The low half of an octet; the high half if the row before is the low one. */
    static Element half(ElementType<?> type) {
        return row(NO_IDENTIFIER, type, Presence.M, Format.HALF, 1, 1);
    }

    /** Gives the element another name than its type's. */
    Element named(String nameInMessage) {
        name = nameInMessage;
        return this;
    }

    /** Binds the element to components of the message's record. */
    Element to(String... names) {
        components = List.of(names);
        return this;
    }

    /** Sets the value that is sent of an element without a component. */
    Element sends(String hex) {
        sent = OctetString.ofHex(hex);
        return this;
    }

    /** Sets the component's value for an absent element, if it is not that of the component's type. */
    Element absentAs(Object value) {
        absent = value;
        return this;
    }

    /** Restricts the element to uplink messages. */
    Element up() {
        only = Direction.UPLINK;
        return this;
    }

    /** Restricts the element to downlink messages. */
    Element down() {
        only = Direction.DOWNLINK;
        return this;
    }

    public ElementType<?> type() {
        return type;
    }

    /** The components of the record with the value; none if the suite does not use it. */
    public List<String> components() {
        return components;
    }

    boolean isIn(Direction direction) {
        return only == null || only == direction;
    }

    /** True if a message without the element is refused by the walk over the elements with identifiers. */
    boolean isRequired() {
        return isMandatory() && format.hasIdentifier() && !components.isEmpty();
    }

    int fixedLength() {
        return mostLength - (format == Format.TV || format == Format.T ? 1 : 0);
    }

    boolean isMandatory() {
        return presence == Presence.M;
    }

    private int overhead() {
        return (format.hasIdentifier() ? 1 : 0) + (format.hasLength() ? 1 : 0);
    }

    /** True if a value may have this length, in octets. */
    boolean allows(int valueLength) {
        int length = valueLength + overhead();
        return length >= leastLength && length <= mostLength;
    }

    byte[] randomValue(RandomGenerator random) {
        byte[] value = new byte[random.nextInt(leastLength, mostLength + 1) - overhead()];
        random.nextBytes(value);
        if (format == Format.HALF) {
            value[0] &= 0x0f;
        }
        return value;
    }

    /** The cells of the row in the standard's table: IEI, element, clause, presence, format, length. */
    public List<String> cells() {
        return List.of(
                identifier == NO_IDENTIFIER ? "" : String.format(Locale.ROOT, "%02X", identifier),
                name,
                type.title() + " " + type.clause(),
                presence.name(),
                format == Format.HALF ? "V" : format.name(),
                format == Format.HALF
                        ? "1/2"
                        : leastLength == mostLength ? "" + mostLength : leastLength + "-" + mostLength);
    }
}
