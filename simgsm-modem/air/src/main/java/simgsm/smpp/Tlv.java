package simgsm.smpp;

import java.nio.charset.StandardCharsets;
import simgsm.octets.OctetString;

/** One optional parameter (5.3). */
public record Tlv(int tag, OctetString value) {
    public static final int RECEIPTED_MESSAGE_ID = 0x001e;
    /** The lowest two octets of the message id, equal in a repeated delivery. */
    public static final int USER_MESSAGE_REFERENCE = 0x0204;

    public static final int SAR_REFERENCE = 0x020c;
    public static final int SAR_TOTAL = 0x020e;
    public static final int SAR_PART = 0x020f;
    static final int INTERFACE_VERSION = 0x0210;
    public static final int MESSAGE_PAYLOAD = 0x0424;
    public static final int MESSAGE_STATE = 0x0427;

    public static Tlv ofOctet(int tag, int value) {
        return new Tlv(tag, OctetString.of(new byte[] {(byte) value}));
    }

    public static Tlv ofTwoOctets(int tag, int value) {
        return new Tlv(tag, OctetString.of(new byte[] {(byte) (value >> 8), (byte) value}));
    }

    public static Tlv ofText(int tag, String text) {
        return new Tlv(tag, OctetString.of((text + "\0").getBytes(StandardCharsets.ISO_8859_1)));
    }
}
