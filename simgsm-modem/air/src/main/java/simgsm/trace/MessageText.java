package simgsm.trace;

import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.CallControl;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Message;
import simgsm.air.Layer3Type;
import simgsm.air.ProtocolViolation;
import simgsm.air.RelayMessage;
import simgsm.air.RelayType;
import simgsm.air.ShortMessageControl;
import simgsm.air.SupplementaryService;
import simgsm.octets.OctetString;

/**
 * A message in words: its name, its fields, its octets.
 *
 * @param name in the standard: "Setup", "CP-DATA (RP-DATA SUBMIT)", "Paging Command"
 */
public record MessageText(String name, List<Field> fields, OctetString octets) {
    /**
     * A part of the message.
     *
     * @param from index of its first octet
     * @param to index after its last octet; as {@code from} for a part without octets
     */
    public record Field(String name, String value, int from, int to) {
        @Override
        public String toString() {
            return name + ": " + value;
        }
    }

    /** Key of the field with the reason why a message cannot be read. */
    static final String WRONG = "wrong";

    private static final int TP_TYPE_MASK = 0x03;
    /** Discriminator and message type of layer 3 and RSL. */
    private static final int HEADER_LENGTH = 2;

    public MessageText {
        fields = List.copyOf(fields);
    }

    /** The octets of a field, counted from 0. @param field index of the field */
    public BitSet octetsOf(int field) {
        BitSet found = new BitSet();
        found.set(fields.get(field).from, fields.get(field).to);
        for (int octet = HEADER_LENGTH; octet < octets.length(); octet++) {
            if (covering(octet) < 0 && fieldAt(octet) == field) {
                found.set(octet);
            }
        }
        return found;
    }

    /**
     * The field of an octet: the one with the fewest octets. An octet after the header that no field has, such as a length, belongs
     * to the next field, or to the last one. -1 for none.
     */
    public int fieldAt(int octet) {
        int field = covering(octet);
        for (int next = octet; field < 0 && next >= HEADER_LENGTH && next < octets.length(); next++) {
            field = covering(next);
        }
        for (int previous = octet; field < 0 && previous >= HEADER_LENGTH; previous--) {
            field = covering(previous);
        }
        return field;
    }

    private int covering(int octet) {
        int found = -1;
        for (int i = 0; i < fields.size(); i++) {
            Field field = fields.get(i);
            boolean isIn = field.from <= octet && octet < field.to;
            if (isIn && (found < 0 || field.to - field.from < fields.get(found).to - fields.get(found).from)) {
                found = i;
            }
        }
        return found;
    }

    /** The text of a layer-3 message in English. */
    public static MessageText ofLayer3(OctetString octets, Direction direction) {
        return ofLayer3(octets, direction, Locale.ROOT);
    }

    /**
     * The text of a layer-3 message, with the fields of its short message; of a broken one the cause and the fault.
     */
    public static MessageText ofLayer3(OctetString octets, Direction direction, Locale language) {
        FieldList fields = new FieldList(FieldTexts.in(language));
        int sendSequence = Layer3Codec.sendSequence(octets.toArray());
        if (sendSequence >= 0 && direction == Direction.UPLINK) {
            fields.add("sendSequenceNumber", sendSequence, 1, 2);
        }
        try {
            Layer3Message message = Layer3Codec.decode(octets.toArray(), direction);
            new Layer3Fields(fields, direction, Layer3Codec.split(octets.toArray(), direction)).add(message);
            return new MessageText(nameOf(message, direction), fields.fields(), octets);
        } catch (ProtocolViolation violation) {
            fields.fields().replaceAll(field -> new Field(field.name, field.value, 0, 0));
            fields.add("cause", violation.statusCause());
            fields.add(WRONG, violation.getMessage());
            return new MessageText(
                    violation.header().map(Layer3Header::name).orElse("unreadable message"), fields.fields(), octets);
        }
    }

    /** The text of an RSL message, or of the layer-3 message in it. */
    public static MessageText ofRsl(OctetString octets, Locale language) {
        try {
            RslPdu message = RslPdu.decode(octets.toArray());
            Optional<OctetString> layer3 = message.find(RslElement.L3_INFORMATION);
            if (layer3.isEmpty()) {
                return RslText.of(message, octets, language);
            }
            boolean isDown = message.type() == RslType.DATA_REQUEST;
            return ofLayer3(layer3.get(), isDown ? Direction.DOWNLINK : Direction.UPLINK, language);
        } catch (ProtocolViolation violation) {
            FieldList fields = new FieldList(FieldTexts.in(language));
            fields.add(WRONG, violation.getMessage());
            return new MessageText("?", fields.fields(), octets);
        }
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

    private static String relayName(RelayMessage relay, Direction direction) {
        if (relay instanceof RelayMessage.RpData data) {
            return "RP-DATA " + transferName(data.tpdu().octet(0) & TP_TYPE_MASK, direction);
        }
        return RelayType.of(relay).title();
    }

    /** TP-MTI (TS 23.040, 9.2.3.1): a number has a different meaning in each direction. */
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
