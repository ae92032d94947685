package simgsm.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.abis.RslCodec;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Message;
import simgsm.air.Layer3Type;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage;
import simgsm.air.ShortMessageControl;
import simgsm.air.SupplementaryService;
import simgsm.octets.OctetString;

/**
 * A message in words: its name, its fields in order, its octets.
 *
 * @param name as the standard has it: "Setup", "CP-DATA (RP-DATA SUBMIT)", "Paging Command"
 */
public record MessageText(String name, List<Field> fields, OctetString octets) {
    /** A part of the message: its name and its value. */
    public record Field(String name, String value) {
        @Override
        public String toString() {
            return name + ": " + value;
        }
    }

    private static final int TP_TYPE_MASK = 0x03;

    public MessageText {
        fields = List.copyOf(fields);
    }

    /** The text of a layer-3 message; of a broken one the cause and what is wrong. */
    public static MessageText ofLayer3(OctetString octets, Direction direction) {
        List<Field> fields = new ArrayList<>();
        int sendSequence = Layer3Codec.sendSequence(octets.toArray());
        if (sendSequence >= 0 && direction == Direction.UPLINK) {
            fields.add(new Field("send sequence number", String.valueOf(sendSequence)));
        }
        try {
            Layer3Message message = Layer3Codec.decode(octets.toArray(), direction);
            FieldTexts.add(fields, message);
            CapabilityTexts.add(fields, message, octets, direction);
            return new MessageText(nameOf(message, direction), fields, octets);
        } catch (ProtocolViolation violation) {
            fields.add(new Field("cause", FieldTexts.text(violation.statusCause())));
            fields.add(new Field(FieldOctets.WRONG, violation.getMessage()));
            return new MessageText(
                    violation.header().map(Layer3Header::name).orElse("unreadable message"), fields, octets);
        }
    }

    /** The text of an RSL message, or of the layer-3 message that it carries. */
    public static MessageText ofRsl(RslMessage message) {
        if (message instanceof RslMessage.EstablishIndication establish) {
            return ofLayer3(establish.layer3(), Direction.UPLINK);
        }
        if (message instanceof RslMessage.DataIndication data) {
            return ofLayer3(data.layer3(), Direction.UPLINK);
        }
        if (message instanceof RslMessage.DataRequest data) {
            return ofLayer3(data.layer3(), Direction.DOWNLINK);
        }
        if (message instanceof RslMessage.MeasurementResult result) {
            return ofLayer3(result.report(), Direction.UPLINK);
        }
        List<Field> fields = new ArrayList<>();
        FieldTexts.add(fields, message);
        return new MessageText(nameOf(message), fields, OctetString.of(RslCodec.encode(message)));
    }

    /** The name of a layer-3 message. */
    public static String nameOf(Layer3Message message, Direction direction) {
        String name = Layer3Type.of(message).title();
        if (message instanceof SupplementaryService service) {
            return name
                    + ComponentText.nameOf(service)
                            .map(what -> " (" + what + ")")
                            .orElse("");
        }
        if (message instanceof CallControl.Facility facility) {
            return name + " (" + ComponentText.nameOf(facility.facility()) + ")";
        }
        return message instanceof ShortMessageControl.CpData data
                ? name + " (" + relayName(data.relay(), direction) + ")"
                : name;
    }

    /** The name of an RSL message, without the layer-3 message that it carries. */
    public static String nameOf(RslMessage message) {
        if (message instanceof RslMessage.PagingCommand) {
            return "Paging Command";
        }
        if (message instanceof RslMessage.SmsBroadcastCommand) {
            return "SMS Broadcast Command";
        }
        return FieldTexts.spaced(message.getClass().getSimpleName(), true);
    }

    /** The transfer unit of a short message in a layer-3 message; empty for every other message. */
    public static Optional<OctetString> tpdu(OctetString layer3, Direction direction) {
        try {
            return Layer3Codec.decode(layer3.toArray(), direction) instanceof ShortMessageControl.CpData data
                            && data.relay() instanceof RelayMessage.RpData relay
                    ? Optional.of(relay.tpdu())
                    : Optional.empty();
        } catch (ProtocolViolation violation) {
            return Optional.empty();
        }
    }

    private static String relayName(RelayMessage relay, Direction direction) {
        if (relay instanceof RelayMessage.RpData data) {
            return "RP-DATA " + transferName(data.tpdu().octet(0) & TP_TYPE_MASK, direction);
        }
        if (relay instanceof RelayMessage.RpAck) {
            return "RP-ACK";
        }
        return relay instanceof RelayMessage.RpError ? "RP-ERROR" : "RP-SMMA";
    }

    /** TP-MTI (TS 23.040, 9.2.3.1): the same number means another unit in each direction. */
    private static String transferName(int type, Direction direction) {
        boolean up = direction == Direction.UPLINK;
        return switch (type) {
            case 0 -> up ? "DELIVER-REPORT" : "DELIVER";
            case 1 -> up ? "SUBMIT" : "SUBMIT-REPORT";
            case 2 -> up ? "COMMAND" : "STATUS-REPORT";
            default -> "reserved";
        };
    }
}
