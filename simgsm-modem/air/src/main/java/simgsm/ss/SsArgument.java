package simgsm.ss;

import java.util.Optional;
import simgsm.air.MessageReader;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.SemiOctets;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * The argument of an operation on a supplementary service (TS 29.002, 17.7.4: SS-ForBS-Code and RegisterSS-Arg). The basic
 * service, which a user may name, is left out: every service is for all calls.
 *
 * @param service SS-Code, one octet
 * @param forwardedTo the number, with a plus sign if it is international
 */
public record SsArgument(int service, Optional<String> forwardedTo) {
    /** [4] IMPLICIT in RegisterSS-Arg. */
    private static final int FORWARDED_TO = 0x84;

    /** International number, ISDN numbering plan (TS 29.002, 17.7.8: AddressString); {@code 0x81} for one of unknown type. */
    private static final int INTERNATIONAL = 0x91;

    private static final int UNKNOWN_TYPE = 0x81;
    private static final int TYPE_OF_NUMBER = 0x70;
    private static final int INTERNATIONAL_TYPE = 0x10;

    OctetString encode() {
        OctetWriter body = BerElement.write(new OctetWriter(), BerElement.OCTET_STRING, service);
        forwardedTo.ifPresent(number -> BerElement.write(body, FORWARDED_TO, address(number)));
        return BerElement.write(new OctetWriter(), BerElement.SEQUENCE, body.toOctetString())
                .toOctetString();
    }

    /** @throws ProtocolViolation if it is no sequence that begins with a service's code */
    public static SsArgument decode(OctetString argument) throws ProtocolViolation {
        MessageReader in =
                new MessageReader(BerElement.read(new MessageReader(argument), BerElement.SEQUENCE, "the argument"));
        int service = new BerElement(
                        BerElement.OCTET_STRING, BerElement.read(in, BerElement.OCTET_STRING, "the service's code"))
                .octet("the service's code");
        Optional<String> number = Optional.empty();
        while (in.hasMore()) {
            BerElement element = BerElement.read(in, "the argument");
            if (element.tag() == FORWARDED_TO) {
                number = Optional.of(readAddress(element.content()));
            }
        }
        return new SsArgument(service, number);
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
