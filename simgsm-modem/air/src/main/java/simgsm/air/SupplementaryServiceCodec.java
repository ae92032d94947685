package simgsm.air;

import java.util.Optional;
import simgsm.air.SupplementaryService.SsFacility;
import simgsm.air.SupplementaryService.SsRegister;
import simgsm.air.SupplementaryService.SsReleaseComplete;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** What follows the message type in supplementary service messages (TS 24.080, 2.2 to 2.5). */
final class SupplementaryServiceCodec {
    private static final int FACILITY = 0x1c;
    private static final int CAUSE = 0x08;
    private static final int VERSION = 0x7f;

    private SupplementaryServiceCodec() {}

    static void write(OctetWriter out, SupplementaryService message, Direction direction) {
        if (message instanceof SsRegister register) {
            writeFacility(out.octet(FACILITY), register.facility());
            register.version().ifPresent(version -> out.octet(VERSION).octet(1).octet(version));
        } else if (message instanceof SsFacility facility) {
            writeFacility(out, facility.facility());
        } else if (message instanceof SsReleaseComplete complete) {
            complete.cause()
                    .ifPresent(
                            cause -> CauseElement.write(out.octet(CAUSE), cause, CauseLocation.of(direction, false)));
            complete.facility().ifPresent(facility -> writeFacility(out.octet(FACILITY), facility));
        }
    }

    private static void writeFacility(OctetWriter out, OctetString facility) {
        out.octet(facility.length()).string(facility);
    }

    static SupplementaryService read(Layer3Type type, TransactionIdentifier transaction, MessageReader in)
            throws ProtocolViolation {
        return switch (type) {
            case SS_REGISTER -> readRegister(transaction, in);
            case SS_FACILITY -> {
                OctetString facility = in.lengthAndValue("facility").rest();
                optional(in).skipAll();
                yield new SsFacility(transaction, facility);
            }
            default -> readReleaseComplete(transaction, in);
        };
    }

    /** The facility is mandatory, although it has an identifier. */
    private static SsRegister readRegister(TransactionIdentifier transaction, MessageReader in)
            throws ProtocolViolation {
        if (!in.hasMore() || in.octet("facility identifier") != FACILITY) {
            throw ProtocolViolation.invalid("a facility was expected first");
        }
        OctetString facility = in.lengthAndValue("facility").rest();
        Optional<MessageReader> version = optional(in).first(VERSION);
        return new SsRegister(
                transaction,
                facility,
                version.isPresent() && version.get().hasMore()
                        ? Optional.of(version.get().octet("SS version indicator"))
                        : Optional.empty());
    }

    private static SsReleaseComplete readReleaseComplete(TransactionIdentifier transaction, MessageReader in)
            throws ProtocolViolation {
        OptionalElements elements = optional(in);
        Optional<Cause> cause = Optional.empty();
        Optional<OctetString> facility = Optional.empty();
        for (int identifier = elements.next(); identifier >= 0; identifier = elements.next()) {
            if (identifier == CAUSE) {
                cause = CauseElement.readOptional(elements.value()).map(CauseElement::cause);
            } else if (identifier == FACILITY) {
                facility = Optional.of(elements.value().rest());
            }
        }
        return new SsReleaseComplete(transaction, cause, facility);
    }

    private static OptionalElements optional(MessageReader in) {
        return new OptionalElements(in, OptionalElements.FixedElements.NONE, CAUSE);
    }
}
