package simgsm.ss;

import java.util.Optional;
import java.util.Set;
import simgsm.air.MessageReader;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.SemiOctets;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * The argument of an operation on a supplementary service (TS 29.002, 17.7.4: SS-ForBS-Code and RegisterSS-Arg).
 *
 * @param service SS-Code, one octet
 * @param basicService tag and code of the basic service group; empty for all
 * @param forwardedTo number, with a plus sign if international
 * @param noReplySeconds ringing time before forwarding
 */
public record SsArgument(
        int service, Optional<Integer> basicService, Optional<String> forwardedTo, Optional<Integer> noReplySeconds) {
    /** [2] and [3] in BasicServiceCode. */
    private static final int BEARER_SERVICE = 0x82;

    private static final int TELESERVICE = 0x83;
    /** [5] IMPLICIT in RegisterSS-Arg. */
    private static final int NO_REPLY_TIME = 0x85;
    /** Teleservices that include speech (TS 29.002, 17.7.9): all, speech, telephony, all but short messages. */
    private static final Set<Integer> SPEECH = Set.of(0x00, 0x10, 0x11, 0x80);

    /** [4] IMPLICIT in RegisterSS-Arg. */
    private static final int FORWARDED_TO = 0x84;

    /** International number, ISDN numbering plan (TS 29.002, 17.7.8: AddressString); {@code 0x81} for one of unknown type. */
    private static final int INTERNATIONAL = 0x91;

    private static final int UNKNOWN_TYPE = 0x81;
    private static final int TYPE_OF_NUMBER = 0x70;
    private static final int INTERNATIONAL_TYPE = 0x10;

    OctetString encode() {
        OctetWriter body = BerElement.write(new OctetWriter(), BerElement.OCTET_STRING, service);
        basicService.ifPresent(group -> BerElement.write(body, group >> 8, group & 0xff));
        forwardedTo.ifPresent(number -> BerElement.write(body, FORWARDED_TO, address(number)));
        noReplySeconds.ifPresent(seconds -> BerElement.write(body, NO_REPLY_TIME, seconds));
        return BerElement.write(new OctetWriter(), BerElement.SEQUENCE, body.toOctetString())
                .toOctetString();
    }

    /** @throws ProtocolViolation unless it is a sequence that begins with a service's code */
    public static SsArgument decode(OctetString argument) throws ProtocolViolation {
        MessageReader in =
                new MessageReader(BerElement.read(new MessageReader(argument), BerElement.SEQUENCE, "the argument"));
        int service = new BerElement(
                        BerElement.OCTET_STRING, BerElement.read(in, BerElement.OCTET_STRING, "the service's code"))
                .octet("the service's code");
        Optional<Integer> group = Optional.empty();
        Optional<String> number = Optional.empty();
        Optional<Integer> seconds = Optional.empty();
        while (in.hasMore()) {
            BerElement element = BerElement.read(in, "the argument");
            if (element.tag() == FORWARDED_TO) {
                number = Optional.of(readAddress(element.content()));
            } else if (element.tag() == BEARER_SERVICE || element.tag() == TELESERVICE) {
                group = Optional.of(element.tag() << 8 | element.octet("the basic service"));
            } else if (element.tag() == NO_REPLY_TIME) {
                seconds = Optional.of(element.octet("the no reply time"));
            }
        }
        return new SsArgument(service, group, number, seconds);
    }

    /** The answer of a network with only speech and short messages; empty if the group includes speech. */
    public Optional<SsError> refusal() {
        if (basicService.isEmpty()) {
            return Optional.empty();
        }
        if (basicService.get() >> 8 == BEARER_SERVICE) {
            return Optional.of(SsError.BEARER_SERVICE_NOT_PROVISIONED);
        }
        return SPEECH.contains(basicService.get() & 0xff)
                ? Optional.empty()
                : Optional.of(SsError.TELESERVICE_NOT_PROVISIONED);
    }

    /** An address string (TS 29.002, 17.7.8). */
    static OctetString address(String number) {
        boolean isInternational = number.startsWith("+");
        OctetWriter out = new OctetWriter().octet(isInternational ? INTERNATIONAL : UNKNOWN_TYPE);
        SemiOctets.write(out, number, isInternational ? 1 : 0);
        return out.toOctetString();
    }

    static String readAddress(OctetString address) throws ProtocolViolation {
        MessageReader in = new MessageReader(address);
        int type = in.octet("type of number");
        String digits = SemiOctets.read(in);
        if (!digits.matches("[0-9]{1," + Msisdn.MAX_DIGITS + "}")) {
            throw ProtocolViolation.invalid("\"" + digits + "\" is no number to which calls can be forwarded");
        }
        return ((type & TYPE_OF_NUMBER) == INTERNATIONAL_TYPE ? "+" : "") + digits;
    }
}
