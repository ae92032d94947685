package simgsm.ss;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.ss.Component.Invoke;
import simgsm.ss.Component.Reject;
import simgsm.ss.Component.ReturnError;
import simgsm.ss.Component.ReturnResult;

/**
 * Encodes and decodes components of facility elements (TS 24.080, 3.6). A facility has one component; anything after
 * it is ignored.
 */
public final class ComponentCodec {
    private static final int INVOKE = 0xa1;
    private static final int RETURN_RESULT = 0xa2;
    private static final int RETURN_ERROR = 0xa3;
    private static final int REJECT = 0xa4;
    private static final int LINKED_ID = 0x80;

    private ComponentCodec() {}

    public static OctetString encode(Component component) {
        OctetWriter body = new OctetWriter();
        int tag;
        if (component instanceof Invoke invoke) {
            tag = INVOKE;
            BerElement.write(body, BerElement.INTEGER, invoke.id());
            BerElement.write(body, BerElement.INTEGER, invoke.operation()).string(invoke.argument());
        } else if (component instanceof ReturnResult result) {
            tag = RETURN_RESULT;
            BerElement.write(body, BerElement.INTEGER, result.id());
            result.operation().ifPresent(operation -> {
                OctetWriter sequence = BerElement.write(new OctetWriter(), BerElement.INTEGER, operation);
                BerElement.write(
                        body,
                        BerElement.SEQUENCE,
                        sequence.string(result.result()).toOctetString());
            });
        } else if (component instanceof ReturnError error) {
            tag = RETURN_ERROR;
            BerElement.write(body, BerElement.INTEGER, error.id());
            BerElement.write(body, BerElement.INTEGER, error.error());
        } else {
            tag = REJECT;
            Reject reject = (Reject) component;
            reject.id()
                    .ifPresentOrElse(
                            id -> BerElement.write(body, BerElement.INTEGER, id),
                            () -> BerElement.write(body, BerElement.NULL, Component.NONE));
            BerElement.write(body, reject.problem().tag(), reject.problem().code());
        }
        return BerElement.write(new OctetWriter(), tag, body.toOctetString()).toOctetString();
    }

    /** @throws ComponentFault with the answer for the sender */
    public static Component decode(OctetString facility) throws ComponentFault {
        Optional<Integer> id = Optional.empty();
        try {
            BerElement whole = BerElement.read(new MessageReader(facility), "the component");
            if (whole.tag() < INVOKE || whole.tag() > REJECT) {
                throw new ComponentFault(
                        id, SsProblem.UNRECOGNIZED_COMPONENT, String.format("its tag is 0x%02x", whole.tag()));
            }
            MessageReader in = new MessageReader(whole.content());
            BerElement first = BerElement.read(in, "the invoke identifier");
            if (whole.tag() == REJECT) {
                return readReject(first, in);
            }
            id = Optional.of(identifier(first));
            return switch (whole.tag()) {
                case INVOKE -> readInvoke(id.get(), in);
                case RETURN_RESULT -> readResult(id.get(), in);
                default -> new ReturnError(id.get(), integer(in, "the error code"));
            };
        } catch (ProtocolViolation violation) {
            throw new ComponentFault(id, SsProblem.BADLY_STRUCTURED_COMPONENT, violation.getMessage());
        }
    }

    /**
     * The index after each element of the component read by {@link #decode}; those of a sequence are the component's.
     */
    public static List<Integer> elementEnds(OctetString facility) {
        List<Integer> ends = new ArrayList<>();
        int at = BerElement.content(facility, 0);
        while (at + 1 < facility.length() && BerElement.content(facility, at) <= facility.length()) {
            int content = BerElement.content(facility, at);
            if (facility.octet(0) == RETURN_RESULT && facility.octet(at) == BerElement.SEQUENCE && ends.size() == 1) {
                at = content;
            } else {
                at = Math.min(facility.length(), content + facility.octet(content - 1));
                ends.add(at);
            }
        }
        return ends;
    }

    private static int identifier(BerElement element) throws ProtocolViolation {
        int id = element.octet("the invoke identifier");
        if (element.tag() != BerElement.INTEGER || id > 0x7f) {
            throw ProtocolViolation.invalid("the invoke identifier is no number of 0 to 127");
        }
        return id;
    }

    private static int integer(MessageReader in, String what) throws ProtocolViolation {
        return new BerElement(BerElement.INTEGER, BerElement.read(in, BerElement.INTEGER, what)).octet(what);
    }

    private static Invoke readInvoke(int id, MessageReader in) throws ProtocolViolation {
        BerElement next = BerElement.read(in, "the operation code");
        if (next.tag() == LINKED_ID) {
            next = BerElement.read(in, "the operation code");
        }
        if (next.tag() != BerElement.INTEGER) {
            throw ProtocolViolation.invalid("the operation has no local code");
        }
        return new Invoke(id, next.octet("the operation code"), in.rest());
    }

    private static ReturnResult readResult(int id, MessageReader in) throws ProtocolViolation {
        if (!in.hasMore()) {
            return new ReturnResult(id);
        }
        MessageReader sequence = new MessageReader(BerElement.read(in, BerElement.SEQUENCE, "the result"));
        int operation = integer(sequence, "the operation code");
        return new ReturnResult(id, Optional.of(operation), sequence.rest());
    }

    private static Reject readReject(BerElement first, MessageReader in) throws ProtocolViolation {
        Optional<Integer> id = first.tag() == BerElement.NULL ? Optional.empty() : Optional.of(identifier(first));
        BerElement problem = BerElement.read(in, "the problem code");
        return new Reject(
                id,
                SsProblem.of(problem.tag(), problem.octet("the problem code"))
                        .orElse(SsProblem.UNRECOGNIZED_COMPONENT));
    }
}
