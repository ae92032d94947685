package simgsm.abis;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.ChannelNumber;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * One RSL message between a base station and its controller: the type, and the elements in order of sending.
 * Terminals with their own cell use {@link RslMessage}.
 *
 * <p>Unknown elements are read as TLV and dropped. Of two equal elements the first is kept.
 */
public final class RslPdu {
    private record Element(RslElement type, OctetString value) {}

    private static final Element[] NONE = {};

    private final RslType type;
    /** In order; a message has few elements, found faster in an array than in a map. */
    private final Element[] elements;

    private RslPdu(RslType type, Element[] elements) {
        this.type = type;
        this.elements = elements;
    }

    /** A message without elements. */
    public static RslPdu of(RslType type) {
        return new RslPdu(type, NONE);
    }

    /** A message about a channel. */
    public static RslPdu of(RslType type, ChannelNumber channel) {
        return of(type).with(RslElement.CHANNEL_NUMBER, channel.code());
    }

    /** A message of a radio link. @param link SAPI in bits 3-1; bit 7 set for the SACCH (TS 48.058, 9.3.2) */
    public static RslPdu of(RslType type, ChannelNumber channel, int link) {
        return of(type, channel).with(RslElement.LINK_IDENTIFIER, link);
    }

    /** A copy with one more element. @param octets values of 8 bits */
    public RslPdu with(RslElement element, int... octets) {
        byte[] value = new byte[octets.length];
        for (int i = 0; i < octets.length; i++) {
            value[i] = (byte) octets[i];
        }
        return with(element, OctetString.of(value));
    }

    /**
     * A copy with one more element.
     *
     * @throws IllegalArgumentException for another length than the element's, or a second one of a kind
     */
    public RslPdu with(RslElement element, OctetString value) {
        if (element.length() >= 0) {
            value.requireLength(element.toString(), element.length());
        }
        if (has(element)) {
            throw new IllegalArgumentException("RSL " + type.title() + " with two elements " + element);
        }
        return new RslPdu(type, appended(elements, element, value));
    }

    private static Element[] appended(Element[] elements, RslElement type, OctetString value) {
        Element[] more = Arrays.copyOf(elements, elements.length + 1);
        more[elements.length] = new Element(type, value);
        return more;
    }

    public RslType type() {
        return type;
    }

    /** The elements in their order. */
    public Map<RslElement, OctetString> elements() {
        Map<RslElement, OctetString> byType = new LinkedHashMap<>();
        for (Element element : elements) {
            byType.put(element.type(), element.value());
        }
        return byType;
    }

    public boolean has(RslElement element) {
        return find(element).isPresent();
    }

    /** The value of an optional element. */
    public Optional<OctetString> find(RslElement element) {
        return find(elements, element);
    }

    private static Optional<OctetString> find(Element[] elements, RslElement type) {
        for (Element element : elements) {
            if (element.type() == type) {
                return Optional.of(element.value());
            }
        }
        return Optional.empty();
    }

    /** The value of a mandatory element. @throws ProtocolViolation if it is missing */
    public OctetString value(RslElement element) throws ProtocolViolation {
        return find(element)
                .orElseThrow(() -> new ProtocolViolation(
                        Cause.INVALID_MANDATORY_INFORMATION, "RSL " + type.title() + " without " + element));
    }

    /** A reader of a mandatory element's value. */
    public MessageReader reader(RslElement element) throws ProtocolViolation {
        return new MessageReader(value(element));
    }

    /** The first octet of a mandatory element. */
    public int octet(RslElement element) throws ProtocolViolation {
        return reader(element).octet(element.toString());
    }

    /** The first two octets of a mandatory element as a number. */
    public int twoOctets(RslElement element) throws ProtocolViolation {
        return reader(element).twoOctets(element.toString());
    }

    /** The channel that the message is about. */
    public ChannelNumber channel() throws ProtocolViolation {
        return ChannelNumber.ofCode(octet(RslElement.CHANNEL_NUMBER));
    }

    /** The service access point of a radio link, 0 to 7. */
    public int sapi() throws ProtocolViolation {
        return octet(RslElement.LINK_IDENTIFIER) & 0x07;
    }

    /** The payload of an {@link IpaFrame#RSL} frame. */
    public byte[] encode() {
        OctetWriter out = new OctetWriter().octet(type.discriminator()).octet(type.code());
        for (Element element : elements) {
            OctetString value = element.value();
            out.octet(element.type().tag());
            if (element.type().length() == RslElement.LONG) {
                out.twoOctets(value.length());
            } else if (element.type().length() == RslElement.VARIABLE) {
                out.octet(value.length());
            }
            out.string(value);
        }
        return out.toArray();
    }

    /** The message of a payload. @throws ProtocolViolation for an unknown type or an element that is cut off */
    public static RslPdu decode(byte[] payload) throws ProtocolViolation {
        MessageReader in = new MessageReader(payload);
        RslType type = RslType.of(in.octet("RSL discriminator"), in.octet("RSL message type"));
        Element[] elements = NONE;
        while (in.hasMore() && type != RslType.MEASUREMENT_PREPROCESSING_DEFAULTS) {
            RslElement element = RslElement.ofTag(in.octet("RSL element"));
            OctetString value = value(in, element);
            if (element != null && find(elements, element).isEmpty()) {
                elements = appended(elements, element, value);
            }
        }
        return new RslPdu(type, elements);
    }

    private static OctetString value(MessageReader in, RslElement element) throws ProtocolViolation {
        String what = element == null ? "RSL element" : element.toString();
        int length = element == null ? RslElement.VARIABLE : element.length();
        if (length == RslElement.LONG) {
            length = in.twoOctets(what);
        } else if (length == RslElement.VARIABLE) {
            length = in.octet(what);
        }
        return in.string(length, what);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof RslPdu that && type == that.type && elements().equals(that.elements());
    }

    @Override
    public int hashCode() {
        return 31 * type.hashCode() + elements().hashCode();
    }

    /** The title, and the elements with their octets. */
    @Override
    public String toString() {
        return type.title() + " " + elements();
    }
}
