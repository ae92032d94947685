package simgsm.smpp;

import java.util.List;
import java.util.Optional;
import simgsm.octets.OctetString;

/**
 * The body of submit_sm, deliver_sm and data_sm (4.4.1, 4.6.1, 4.7.1).
 *
 * @param esmClass messaging mode, message type, {@link #HAS_HEADER}, {@link #REPLY_PATH} (5.2.12)
 * @param schedule empty: deliver at once; else 16 characters (7.1.1)
 * @param validity empty: the centre's default; else 16 characters (7.1.1)
 * @param registeredDelivery bits 1-0: requested receipts (5.2.17)
 * @param shortMessage at most 254 octets; a longer one is in the message_payload parameter
 */
public record SmppMessage(
        String serviceType,
        SmppAddress source,
        SmppAddress destination,
        int esmClass,
        int protocolId,
        int priority,
        String schedule,
        String validity,
        int registeredDelivery,
        int replaceIfPresent,
        int dataCoding,
        int defaultMessageId,
        OctetString shortMessage,
        List<Tlv> parameters) {
    public static final int RECEIPT = 0x04;
    public static final int HAS_HEADER = 0x40;
    public static final int REPLY_PATH = 0x80;
    public static final int MAX_SHORT_MESSAGE = 254;

    /** A message with default values for all other fields. */
    public static SmppMessage of(
            SmppAddress source,
            SmppAddress destination,
            int esmClass,
            int protocolId,
            int dataCoding,
            OctetString text,
            List<Tlv> parameters) {
        return new SmppMessage(
                "", source, destination, esmClass, protocolId, 0, "", "", 0, 0, dataCoding, 0, text, parameters);
    }

    public Optional<OctetString> parameter(int tag) {
        for (Tlv parameter : parameters) {
            if (parameter.tag() == tag) {
                return Optional.of(parameter.value());
            }
        }
        return Optional.empty();
    }

    /** The content of short_message or message_payload. */
    public OctetString content() throws SmppViolation {
        Optional<OctetString> payload = parameter(Tlv.MESSAGE_PAYLOAD);
        if (payload.isPresent() && shortMessage.length() > 0) {
            throw new SmppViolation(
                    SmppStatus.OPTIONAL_PARAMETER_NOT_ALLOWED, "both short_message and message_payload hold text");
        }
        return payload.orElse(shortMessage);
    }

    public boolean hasHeader() {
        return (esmClass & HAS_HEADER) != 0;
    }
}
