package simgsm.air;

import static simgsm.air.Element.Format.LV;
import static simgsm.air.Element.Format.TLV;
import static simgsm.air.Element.Format.V;
import static simgsm.air.Element.Presence.M;
import static simgsm.air.Element.Presence.O;
import static simgsm.air.Element.row;
import static simgsm.air.ElementType.*;

import java.util.List;
import simgsm.octets.OctetWriter;

/** The RP messages in CP-DATA (TS 24.011, 7.3): number from the mobile, record and elements. */
public enum RelayType {
    RP_DATA(
            0,
            RelayMessage.RpData.class,
            row(RP_REFERENCE, M, V, 1).to("reference"),
            row(RP_ORIGINATOR, M, LV, 1).sends("").up(),
            row(RP_ORIGINATOR, M, LV, 2, 12).to("serviceCenter").down(),
            row(RP_DESTINATION, M, LV, 2, 12).to("serviceCenter").up(),
            row(RP_DESTINATION, M, LV, 1).sends("").down(),
            row(RP_USER_DATA, M, LV, 2, 233).to("tpdu")),
    RP_ACK(
            2,
            RelayMessage.RpAck.class,
            row(RP_REFERENCE, M, V, 1).to("reference"),
            row(0x41, RP_USER_DATA, O, TLV, 3, 234).to("tpdu")),
    RP_ERROR(
            4,
            RelayMessage.RpError.class,
            row(RP_REFERENCE, M, V, 1).to("reference"),
            row(ElementType.RP_CAUSE, M, LV, 2, 3).to("cause"),
            row(0x41, RP_USER_DATA, O, TLV, 3, 234)),
    RP_SMMA(6, RelayMessage.RpSmma.class, row(RP_REFERENCE, M, V, 1).to("reference"));

    /** Message types from the network are greater by 1. */
    private static final int FROM_NETWORK = 1;

    private static final int TYPE_MASK = 0x07;

    private final int code;
    private final Class<? extends RelayMessage> record;
    private final ElementTable table;

    RelayType(int code, Class<? extends RelayMessage> record, Element... rows) {
        this.code = code;
        this.record = record;
        table = new ElementTable(record, List.of(rows));
    }

    /** The type of a message. */
    public static RelayType of(RelayMessage message) {
        for (RelayType type : values()) {
            if (type.record == message.getClass()) {
                return type;
            }
        }
        throw new AssertionError(message);
    }

    /** The message's name in the standard. */
    public String title() {
        return name().replace('_', '-');
    }

    /** The rows of the message's table in this direction. */
    public List<Element> elements(Direction direction) {
        return table.rows(direction);
    }

    private int code(Direction direction) {
        return direction == Direction.DOWNLINK ? code + FROM_NETWORK : code;
    }

    static void write(OctetWriter out, RelayMessage message, Direction direction) {
        RelayType type = of(message);
        type.table.write(out.octet(type.code(direction)), message, direction);
    }

    /** A violation has the message reference, except in an RP-ACK or RP-ERROR, which the RP layer does not answer (9.3.3). */
    static RelayMessage read(MessageReader in, Direction direction) throws ProtocolViolation {
        int code = in.octet("RP message type") & TYPE_MASK;
        int reference = in.hasMore() ? in.peek() : in.octet("RP message reference");
        try {
            return (RelayMessage) of(code, direction).table.read(in, direction);
        } catch (ProtocolViolation violation) {
            int kind = code & ~FROM_NETWORK;
            throw kind == RP_ACK.code || kind == RP_ERROR.code ? violation : violation.inRelay(reference);
        }
    }

    private static RelayType of(int code, Direction direction) throws ProtocolViolation {
        for (RelayType type : values()) {
            if (type.code(direction) == code && (type != RP_SMMA || direction == Direction.UPLINK)) {
                return type;
            }
        }
        throw new ProtocolViolation(Cause.MESSAGE_TYPE_NON_EXISTENT, "RP message type " + code + " " + direction);
    }

    /** The elements in the octets of a message. */
    static List<ElementTable.Part> split(MessageReader in, Direction direction) throws ProtocolViolation {
        return of(in.octet("RP message type") & TYPE_MASK, direction).table.split(in, direction);
    }
}
