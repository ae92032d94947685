package simgsm.ss;

import java.util.Optional;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * The status of a supplementary service, answered by the network to an operation (TS 24.080, 4.4; TS 29.002, 17.7.4:
 * SS-Info, InterrogateSS-Res).
 *
 * @param flags SS-Status: a sum of the constants
 * @param forwardedTo registered number, with a plus sign if international
 * @param noReplySeconds ringing time before forwarding; empty for other services
 */
public record ServiceStatus(SsCode service, int flags, Optional<String> forwardedTo, Optional<Integer> noReplySeconds) {
    public static final int ACTIVE = 1;
    public static final int REGISTERED = 2;
    public static final int PROVISIONED = 4;

    /** All speech transmission services (TS 29.002, 17.7.9). */
    private static final int ALL_SPEECH = 0x10;

    private static final int TELESERVICE = 0x83;
    private static final int FORWARDING_INFO = 0xa0;
    private static final int SS_DATA = 0xa3;
    private static final int INTERROGATED_STATUS = 0x80;
    private static final int BASIC_SERVICES = 0xa2;
    private static final int FORWARDING_FEATURES = 0xa3;
    /** [4] in ForwardingFeature and in SS-Data. */
    private static final int STATUS = 0x84;
    /** [5] in ForwardingFeature. */
    private static final int NUMBER = 0x85;
    /** [7] in ForwardingFeature. */
    private static final int NO_REPLY_TIME = 0x87;

    public ServiceStatus(SsCode service, int flags, Optional<String> forwardedTo) {
        this(service, flags, forwardedTo, Optional.empty());
    }

    public boolean isActive() {
        return (flags & ACTIVE) != 0;
    }

    public boolean isRegistered() {
        return (flags & REGISTERED) != 0;
    }

    /** The state of the service in a word. */
    public String state() {
        return isActive() ? "active" : isRegistered() ? "registered" : "inactive";
    }

    /** The result of an operation. */
    public OctetString encode(SsOperation operation) {
        return operation == SsOperation.INTERROGATE_SS ? interrogation() : info();
    }

    private OctetString info() {
        OctetWriter body = BerElement.write(new OctetWriter(), BerElement.OCTET_STRING, service.code());
        if (service.isForwarding()) {
            BerElement.write(body, BerElement.SEQUENCE, features());
            return element(FORWARDING_INFO, body.toOctetString());
        }
        return element(SS_DATA, BerElement.write(body, STATUS, flags).toOctetString());
    }

    private OctetString features() {
        OctetWriter feature = BerElement.write(new OctetWriter(), STATUS, flags);
        forwardedTo.ifPresent(number -> BerElement.write(feature, NUMBER, SsArgument.address(number)));
        noReplySeconds.ifPresent(seconds -> BerElement.write(feature, NO_REPLY_TIME, seconds));
        return element(BerElement.SEQUENCE, feature.toOctetString());
    }

    private OctetString interrogation() {
        if (service.isForwarding() && isRegistered()) {
            return element(FORWARDING_FEATURES, features());
        }
        if (isActive()) {
            return element(
                    BASIC_SERVICES,
                    BerElement.write(new OctetWriter(), TELESERVICE, ALL_SPEECH).toOctetString());
        }
        return BerElement.write(new OctetWriter(), INTERROGATED_STATUS, flags).toOctetString();
    }

    private static OctetString element(int tag, OctetString content) {
        return BerElement.write(new OctetWriter(), tag, content).toOctetString();
    }

    /**
     * Reads the result of an operation.
     *
     * @param service requested
     */
    public static ServiceStatus decode(SsCode service, SsOperation operation, OctetString result)
            throws ProtocolViolation {
        BerElement whole = BerElement.read(new MessageReader(result), "the result");
        MessageReader in = new MessageReader(whole.content());
        boolean isInterrogation = operation == SsOperation.INTERROGATE_SS;
        if (isInterrogation && whole.tag() == INTERROGATED_STATUS) {
            return new ServiceStatus(service, whole.octet("the status"), Optional.empty());
        }
        if (isInterrogation && whole.tag() == BASIC_SERVICES) {
            return new ServiceStatus(service, PROVISIONED | ACTIVE, Optional.empty());
        }
        if (isInterrogation && whole.tag() == FORWARDING_FEATURES) {
            return feature(service, in);
        }
        if (!isInterrogation && whole.tag() == FORWARDING_INFO) {
            BerElement next = BerElement.read(in, "the forwarding");
            if (next.tag() == BerElement.OCTET_STRING) {
                next = BerElement.read(in, "the forwarding");
            }
            return feature(service, new MessageReader(next.content()));
        }
        if (!isInterrogation && whole.tag() == SS_DATA) {
            return parts(service, in);
        }
        throw ProtocolViolation.invalid(String.format("the result has tag 0x%02x", whole.tag()));
    }

    /** The first feature of a list. */
    private static ServiceStatus feature(SsCode service, MessageReader list) throws ProtocolViolation {
        return parts(service, new MessageReader(BerElement.read(list, BerElement.SEQUENCE, "the forwarding")));
    }

    private static ServiceStatus parts(SsCode service, MessageReader in) throws ProtocolViolation {
        int flags = 0;
        Optional<String> number = Optional.empty();
        Optional<Integer> seconds = Optional.empty();
        while (in.hasMore()) {
            BerElement element = BerElement.read(in, "the status");
            if (element.tag() == STATUS) {
                flags = element.octet("the status");
            } else if (element.tag() == NUMBER) {
                number = Optional.of(SsArgument.readAddress(element.content()));
            } else if (element.tag() == NO_REPLY_TIME) {
                seconds = Optional.of(element.octet("the no reply time"));
            }
        }
        return new ServiceStatus(service, flags, number, seconds);
    }
}
