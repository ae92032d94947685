package simgsm.air;

import java.util.Optional;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.RelayMessage.RpError;
import simgsm.air.RelayMessage.RpSmma;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.ShortMessageControl.CpError;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** What follows the message type in CP messages, and the RP messages inside CP-DATA (TS 24.011, 7 and 8). */
final class ShortMessageCodec {
    /** RP message types from the mobile; those from the network are greater by 1. */
    private static final int RP_DATA = 0;

    private static final int RP_ACK = 2;
    private static final int RP_ERROR = 4;
    private static final int RP_SMMA = 6;

    private static final int RP_USER_DATA = 0x41;

    private ShortMessageCodec() {}

    static void write(OctetWriter out, ShortMessageControl message, Direction direction) {
        if (message instanceof CpData data) {
            int start = out.openLength();
            writeRelay(out, data.relay(), direction);
            out.closeLength(start);
        } else if (message instanceof CpError error) {
            out.octet(error.cause());
        }
    }

    private static void writeRelay(OctetWriter out, RelayMessage message, Direction direction) {
        int fromNetwork = direction == Direction.DOWNLINK ? 1 : 0;
        if (message instanceof RpData data) {
            out.octet(RP_DATA + fromNetwork).octet(data.reference());
            writeAddresses(out, data.serviceCenter(), direction);
            out.octet(data.tpdu().length()).string(data.tpdu());
        } else if (message instanceof RpAck acknowledge) {
            out.octet(RP_ACK + fromNetwork).octet(acknowledge.reference());
            acknowledge
                    .tpdu()
                    .ifPresent(
                            tpdu -> out.octet(RP_USER_DATA).octet(tpdu.length()).string(tpdu));
        } else if (message instanceof RpError error) {
            out.octet(RP_ERROR + fromNetwork).octet(error.reference());
            out.octet(1).octet(error.cause().code());
        } else if (message instanceof RpSmma memoryAvailable) {
            out.octet(RP_SMMA).octet(memoryAvailable.reference());
        }
    }

    /** Writes originator, then destination; the one of the mobile is always empty. */
    private static void writeAddresses(OctetWriter out, Msisdn serviceCenter, Direction direction) {
        if (direction == Direction.UPLINK) {
            NumberElements.writeCalled(out.octet(0), serviceCenter);
        } else {
            NumberElements.writeCalled(out, serviceCenter);
            out.octet(0);
        }
    }

    static ShortMessageControl read(Layer3Header header, Layer3Type type, MessageReader in) throws ProtocolViolation {
        TransactionIdentifier transaction = header.transaction().orElseThrow();
        return switch (type) {
            case CP_DATA -> new CpData(transaction, readRelay(header, in.lengthAndValue("CP user data")));
            case CP_ACK -> new CpAck(transaction);
            default -> new CpError(transaction, in.octet("CP cause") & 0x7f);
        };
    }

    private static RelayMessage readRelay(Layer3Header header, MessageReader in) throws ProtocolViolation {
        int type = in.octet("RP message type") & 0x07;
        int reference = in.octet("RP message reference");
        try {
            return readRelay(type, reference, in, header.direction());
        } catch (ProtocolViolation violation) {
            throw answersNothing(type) ? violation : violation.in(header.withRelayReference(reference));
        }
    }

    /** A broken RP-ACK or RP-ERROR is not answered at the RP layer (TS 24.011, 9.3.3). */
    private static boolean answersNothing(int type) {
        return (type & ~1) == RP_ACK || (type & ~1) == RP_ERROR;
    }

    private static RelayMessage readRelay(int type, int reference, MessageReader in, Direction direction)
            throws ProtocolViolation {
        boolean fromNetwork = direction == Direction.DOWNLINK;
        switch (fromNetwork ? type - 1 : type) {
            case RP_DATA:
                return readData(reference, in, direction);
            case RP_ACK:
                return new RpAck(reference, readUserData(in));
            case RP_ERROR:
                MessageReader cause = in.lengthAndValue("RP cause");
                return new RpError(reference, RpCause.ofCode(cause.octet("RP cause") & 0x7f));
            case RP_SMMA:
                if (!fromNetwork) {
                    return new RpSmma(reference);
                }
        }
        throw new ProtocolViolation(Cause.MESSAGE_TYPE_NON_EXISTENT, "RP message type " + type + " " + direction);
    }

    private static RpData readData(int reference, MessageReader in, Direction direction) throws ProtocolViolation {
        MessageReader originator = in.lengthAndValue("RP originator address");
        MessageReader destination = in.lengthAndValue("RP destination address");
        Msisdn serviceCenter = NumberElements.read(direction == Direction.UPLINK ? destination : originator);
        OctetString tpdu = in.lengthAndValue("RP user data").rest();
        if (!RelayMessage.isTpduLength(tpdu.length())) {
            throw ProtocolViolation.invalid("RP user data of " + tpdu.length() + " octets, 1 to "
                    + RelayMessage.MAX_TPDU_LENGTH + " were expected");
        }
        return new RpData(reference, serviceCenter, tpdu);
    }

    private static Optional<OctetString> readUserData(MessageReader in) throws ProtocolViolation {
        return new OptionalElements(in, OptionalElements.FixedElements.NONE)
                .first(RP_USER_DATA)
                .filter(value -> RelayMessage.isTpduLength(value.remaining()))
                .map(MessageReader::rest);
    }
}
