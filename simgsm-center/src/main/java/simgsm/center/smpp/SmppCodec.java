package simgsm.center.smpp;

import java.util.Optional;
import simgsm.octets.OctetString;

/** Decodes PDUs; {@link SmppEncoder} encodes them. */
public final class SmppCodec {
    /** Length, command id, status, sequence number, 4 octets each (3.2). */
    public static final int HEADER_LENGTH = 16;

    private static final int MAX_SYSTEM_ID = 16;
    private static final int MAX_PASSWORD = 9;
    private static final int MAX_SYSTEM_TYPE = 13;
    private static final int MAX_ADDRESS_RANGE = 41;
    private static final int MAX_SERVICE_TYPE = 6;
    private static final int MAX_ADDRESS = 21;
    private static final int MAX_DATA_ADDRESS = 65;
    private static final int MAX_TIME = 17;
    private static final int MAX_MESSAGE_ID = 65;

    private SmppCodec() {}

    /**
     * Decodes one PDU.
     *
     * @throws SmppViolation with the response, if the PDU is invalid
     */
    public static SmppPdu decode(byte[] octets) throws SmppViolation {
        return decode(octets, 0, octets.length);
    }

    /** @param to behind the last octet of the PDU, at least {@link #HEADER_LENGTH} behind the first */
    static SmppPdu decode(byte[] octets, int from, int to) throws SmppViolation {
        SmppReader in = new SmppReader(octets, from, to);
        in.word("command_length");
        int id = in.word("command_id");
        int status = in.word("command_status");
        int sequence = in.word("sequence_number");
        boolean isResponse = (id & SmppCommand.RESPONSE) != 0;
        if (id == SmppCommand.RESPONSE) {
            return new SmppPdu.GenericNack(status, sequence);
        }
        Optional<SmppCommand> command = SmppCommand.ofCode(id);
        if (command.isEmpty()) {
            SmppViolation unknown = new SmppViolation(
                    SmppStatus.INVALID_COMMAND_ID, "command 0x" + Integer.toHexString(id) + " is not known");
            throw isResponse
                    ? unknown
                    : unknown.answeredBy(new SmppPdu.GenericNack(SmppStatus.INVALID_COMMAND_ID, sequence));
        }
        if (isResponse) {
            return response(command.get(), status, sequence, in);
        }
        try {
            return request(command.get(), sequence, in);
        } catch (SmppViolation violation) {
            throw violation.answeredBy(refusal(command.get(), violation.status(), sequence));
        }
    }

    /** The response that refuses a request: without a body (4.4.2 and others). */
    static SmppPdu refusal(SmppCommand command, int status, int sequence) {
        return new SmppPdu.PlainResponse(command, status, sequence);
    }

    private static SmppPdu request(SmppCommand command, int sequence, SmppReader in) throws SmppViolation {
        return switch (command) {
            case BIND_RECEIVER, BIND_TRANSMITTER, BIND_TRANSCEIVER -> bind(command, sequence, in);
            case SUBMIT_SM, DELIVER_SM -> new SmppPdu.Message(command, sequence, message(in));
            case DATA_SM -> new SmppPdu.Message(command, sequence, data(in));
            case QUERY_SM -> new SmppPdu.Query(sequence, messageId(in), address(in, MAX_ADDRESS, true));
            case CANCEL_SM -> cancel(sequence, in);
            case ENQUIRE_LINK, UNBIND -> new SmppPdu.Plain(command, sequence);
        };
    }

    private static SmppPdu bind(SmppCommand command, int sequence, SmppReader in) throws SmppViolation {
        String systemId = in.text(MAX_SYSTEM_ID, "system_id", SmppStatus.INVALID_SYSTEM_ID);
        String password = in.text(MAX_PASSWORD, "password", SmppStatus.INVALID_PASSWORD);
        String systemType = in.text(MAX_SYSTEM_TYPE, "system_type", SmppStatus.INVALID_SYSTEM_TYPE);
        int version = in.octet("interface_version");
        in.octet("addr_ton");
        in.octet("addr_npi");
        String range = in.text(MAX_ADDRESS_RANGE, "address_range", SmppStatus.BIND_FAILED);
        return new SmppPdu.Bind(command, sequence, systemId, password, systemType, version, range);
    }

    private static SmppMessage message(SmppReader in) throws SmppViolation {
        String serviceType = in.text(MAX_SERVICE_TYPE, "service_type", SmppStatus.INVALID_SERVICE_TYPE);
        SmppAddress source = address(in, MAX_ADDRESS, true);
        SmppAddress destination = address(in, MAX_ADDRESS, false);
        int esmClass = in.octet("esm_class");
        int protocolId = in.octet("protocol_id");
        int priority = in.octet("priority_flag");
        String schedule = in.text(MAX_TIME, "schedule_delivery_time", SmppStatus.INVALID_SCHEDULE);
        String validity = in.text(MAX_TIME, "validity_period", SmppStatus.INVALID_VALIDITY);
        int registeredDelivery = in.octet("registered_delivery");
        int replace = in.octet("replace_if_present_flag");
        int dataCoding = in.octet("data_coding");
        int defaultMessage = in.octet("sm_default_msg_id");
        int length = in.octet("sm_length");
        if (length > SmppMessage.MAX_SHORT_MESSAGE) {
            throw new SmppViolation(SmppStatus.INVALID_MESSAGE_LENGTH, "sm_length " + length + " is over 254");
        }
        OctetString text = in.string(length, "short_message", SmppStatus.INVALID_MESSAGE_LENGTH);
        return new SmppMessage(
                serviceType,
                source,
                destination,
                esmClass,
                protocolId,
                priority,
                schedule,
                validity,
                registeredDelivery,
                replace,
                dataCoding,
                defaultMessage,
                text,
                in.parameters());
    }

    private static SmppMessage data(SmppReader in) throws SmppViolation {
        String serviceType = in.text(MAX_SERVICE_TYPE, "service_type", SmppStatus.INVALID_SERVICE_TYPE);
        SmppAddress source = address(in, MAX_DATA_ADDRESS, true);
        SmppAddress destination = address(in, MAX_DATA_ADDRESS, false);
        int esmClass = in.octet("esm_class");
        int registeredDelivery = in.octet("registered_delivery");
        int dataCoding = in.octet("data_coding");
        return new SmppMessage(
                serviceType,
                source,
                destination,
                esmClass,
                0,
                0,
                "",
                "",
                registeredDelivery,
                0,
                dataCoding,
                0,
                OctetString.of(new byte[0]),
                in.parameters());
    }

    private static SmppPdu cancel(int sequence, SmppReader in) throws SmppViolation {
        in.text(MAX_SERVICE_TYPE, "service_type", SmppStatus.INVALID_SERVICE_TYPE);
        String messageId = messageId(in);
        return new SmppPdu.Cancel(sequence, messageId, address(in, MAX_ADDRESS, true), address(in, MAX_ADDRESS, false));
    }

    private static String messageId(SmppReader in) throws SmppViolation {
        return in.text(MAX_MESSAGE_ID, "message_id", SmppStatus.INVALID_MESSAGE_ID);
    }

    private static SmppAddress address(SmppReader in, int most, boolean isSource) throws SmppViolation {
        String field = isSource ? "source_addr" : "destination_addr";
        int ton = in.octet(field + " ton");
        int npi = in.octet(field + " npi");
        String value = in.text(most, field, isSource ? SmppStatus.INVALID_SOURCE : SmppStatus.INVALID_DESTINATION);
        return new SmppAddress(ton, npi, value);
    }

    /** The body is optional: peers omit it in refusals, some in all responses. */
    private static SmppPdu response(SmppCommand command, int status, int sequence, SmppReader in) throws SmppViolation {
        return switch (command) {
            case BIND_RECEIVER, BIND_TRANSMITTER, BIND_TRANSCEIVER ->
                new SmppPdu.BindResponse(command, status, sequence, optionalText(in));
            case SUBMIT_SM, DELIVER_SM, DATA_SM ->
                new SmppPdu.MessageResponse(command, status, sequence, optionalText(in));
            case QUERY_SM ->
                in.hasMore()
                        ? new SmppPdu.QueryResponse(
                                status,
                                sequence,
                                messageId(in),
                                in.text(MAX_TIME, "final_date", SmppStatus.INVALID_COMMAND_LENGTH),
                                in.octet("message_state"),
                                in.octet("error_code"))
                        : new SmppPdu.PlainResponse(command, status, sequence);
            case CANCEL_SM, ENQUIRE_LINK, UNBIND -> new SmppPdu.PlainResponse(command, status, sequence);
        };
    }

    private static String optionalText(SmppReader in) throws SmppViolation {
        return in.hasMore() ? in.text(MAX_MESSAGE_ID, "id", SmppStatus.INVALID_COMMAND_LENGTH) : "";
    }

    /** Encodes one PDU. */
    public static byte[] encode(SmppPdu pdu) {
        return SmppEncoder.encode(pdu);
    }
}
