package simgsm.abis;

import java.nio.charset.StandardCharsets;
import simgsm.air.Cause;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetWriter;

/** Converts connection control messages to payloads of {@link IpaFrame#CCM} frames and back. */
public final class CcmCodec {
    private static final int PING = 0x00;
    private static final int PONG = 0x01;
    private static final int IDENTITY_REQUEST = 0x04;
    private static final int IDENTITY_RESPONSE = 0x05;
    private static final int IDENTITY_ACKNOWLEDGE = 0x06;

    private static final int SERIAL_NUMBER_TAG = 0x00;
    private static final int UNIT_NAME_TAG = 0x01;
    private static final int UNIT_ID_TAG = 0x08;
    /** Unit id, MAC address, location, type, hardware, software, name, serial number. */
    private static final int[] ALL_TAGS = {UNIT_ID_TAG, 7, 2, 3, 4, 5, UNIT_NAME_TAG, SERIAL_NUMBER_TAG};

    private CcmCodec() {}

    /** The payload of the message. */
    public static byte[] encode(CcmMessage message) {
        OctetWriter out = new OctetWriter();
        if (message instanceof CcmMessage.Ping) {
            out.octet(PING);
        } else if (message instanceof CcmMessage.Pong) {
            out.octet(PONG);
        } else if (message instanceof CcmMessage.IdentityRequest) {
            out.octet(IDENTITY_REQUEST);
            for (int tag : ALL_TAGS) {
                out.octet(1).octet(tag);
            }
        } else if (message instanceof CcmMessage.IdentityResponse response) {
            out.octet(IDENTITY_RESPONSE);
            if (response.isTower()) {
                writeTag(out, UNIT_ID_TAG, response.unitId());
            }
            writeTag(out, UNIT_NAME_TAG, response.unitName());
            writeTag(out, SERIAL_NUMBER_TAG, response.serialNumber());
        } else {
            out.octet(IDENTITY_ACKNOWLEDGE);
        }
        return out.toArray();
    }

    /** The message of a payload. */
    public static CcmMessage decode(byte[] payload) throws ProtocolViolation {
        MessageReader in = new MessageReader(payload);
        int type = in.octet("CCM message type");
        return switch (type) {
            case PING -> new CcmMessage.Ping();
            case PONG -> new CcmMessage.Pong();
            case IDENTITY_REQUEST -> new CcmMessage.IdentityRequest();
            case IDENTITY_RESPONSE -> identityResponse(in);
            case IDENTITY_ACKNOWLEDGE -> new CcmMessage.IdentityAcknowledge();
            default -> throw new ProtocolViolation(Cause.MESSAGE_TYPE_NON_EXISTENT, "CCM message type " + type);
        };
    }

    private static void writeTag(OctetWriter out, int tag, String text) {
        byte[] octets = text.getBytes(StandardCharsets.UTF_8);
        out.twoOctets(octets.length + 2).octet(tag).bytes(octets).octet(0);
    }

    private static CcmMessage identityResponse(MessageReader in) throws ProtocolViolation {
        String unitName = "";
        String serialNumber = "";
        String unitId = "";
        while (in.hasMore()) {
            MessageReader element = in.part(in.twoOctets("identity tag length"), "identity tag");
            int tag = element.octet("identity tag");
            if (tag == UNIT_NAME_TAG) {
                unitName = text(element);
            } else if (tag == SERIAL_NUMBER_TAG) {
                serialNumber = text(element);
            } else if (tag == UNIT_ID_TAG) {
                unitId = text(element);
            }
        }
        return new CcmMessage.IdentityResponse(unitName, serialNumber, unitId);
    }

    /**
     * The text up to a zero octet or the end. Control characters are refused, because logs and windows show names.
     */
    private static String text(MessageReader element) throws ProtocolViolation {
        String text = new String(element.rest().toArray(), StandardCharsets.UTF_8);
        int zero = text.indexOf('\0');
        String name = zero < 0 ? text : text.substring(0, zero);
        if (name.chars().anyMatch(Character::isISOControl)) {
            throw new ProtocolViolation(
                    Cause.SEMANTICALLY_INCORRECT_MESSAGE, "an identity tag holds a control character");
        }
        return name;
    }
}
