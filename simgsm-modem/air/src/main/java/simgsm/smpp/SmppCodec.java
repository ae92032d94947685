package simgsm.smpp;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simgsm.octets.OctetString;

/** Decodes and encodes PDUs. Each kind has one method that lists its fields in order, for both directions. */
public final class SmppCodec {
    /** Length, command id, status, sequence number, 4 octets each (3.2). */
    public static final int HEADER_LENGTH = 16;

    /** interface_version of SMPP 3.4; a lower one is of 3.3 or earlier (5.2.4). */
    public static final int INTERFACE_VERSION = 0x34;

    /** Version of SMPP 5.0; the centre answers with 3.4 in sc_interface_version. */
    private static final int SMPP_5 = 0x50;
    /** message_state UNKNOWN (5.2.28). */
    private static final int UNKNOWN = 7;
    /** replace_if_present_flag (5.2.18): 0 or 1. */
    private static final int REPLACE = 1;
    /** priority_flag (5.2.14). */
    private static final int MAX_PRIORITY = 3;
    /** sm_default_msg_id (5.2.20): the centre has no predefined messages. */
    private static final int NO_DEFAULT_MESSAGE = 0;

    private static final int MAX_SYSTEM_ID = 16;
    private static final int MAX_PASSWORD = 9;
    private static final int MAX_SYSTEM_TYPE = 13;
    private static final int MAX_ADDRESS_RANGE = 41;
    private static final int MAX_SERVICE_TYPE = 6;
    private static final int MAX_ADDRESS = 21;
    private static final int MAX_DATA_ADDRESS = 65;
    private static final int MAX_TIME = 17;
    private static final int MAX_MESSAGE_ID = 65;

    /** submit_multi, number_of_dests (4.5.1). */
    private static final int MAX_DESTINATIONS = 254;
    /** dest_flag (4.5.1.1). */
    private static final int ADDRESS_FLAG = 1;

    private static final int LIST_FLAG = 2;

    private static final Set<SmppCommand> WITHOUT_BODY_ON_ERRORS =
            EnumSet.of(SmppCommand.BIND_TRANSMITTER, SmppCommand.BIND_RECEIVER, SmppCommand.SUBMIT_SM);

    private static final OctetString NOTHING = OctetString.of(new byte[0]);
    private static final SmppMessage EMPTY =
            SmppMessage.of(SmppAddress.NONE, SmppAddress.NONE, 0, 0, 0, NOTHING, List.of());

    private SmppCodec() {}

    /**
     * Decodes one PDU.
     *
     * @throws SmppViolation with the response, if the PDU is invalid
     */
    public static SmppPdu decode(byte[] octets) throws SmppViolation {
        return decode(octets, 0, octets.length);
    }

    /** @param to end of the PDU, exclusive, at least {@link #HEADER_LENGTH} after its start */
    static SmppPdu decode(byte[] octets, int from, int to) throws SmppViolation {
        SmppReader in = new SmppReader(octets, from, to);
        in.fourOctets("command_length", 0);
        int id = in.fourOctets("command_id", 0);
        int status = in.fourOctets("command_status", 0);
        int sequence = in.fourOctets("sequence_number", 0);
        boolean isResponse = (id & SmppCommand.RESPONSE) != 0;
        Optional<SmppCommand> command = SmppCommand.ofCode(id);
        if (command.isEmpty() || command.get() == SmppCommand.GENERIC_NACK && !isResponse) {
            SmppViolation unknown = new SmppViolation(
                    SmppStatus.INVALID_COMMAND_ID, "command 0x" + Integer.toHexString(id) + " is not known");
            throw isResponse
                    ? unknown
                    : unknown.answeredBy(new SmppPdu.GenericNack(SmppStatus.INVALID_COMMAND_ID, sequence));
        }
        if (isResponse) {
            SmppPdu.Response response = response(command.get(), status, sequence);
            return in.hasBody() ? body(in, response) : response;
        }
        SmppPdu request = request(command.get(), sequence);
        try {
            return body(in, request);
        } catch (SmppViolation violation) {
            throw violation.answeredBy(refusal(request, violation.status()));
        }
    }

    /** Encodes one PDU for a peer of SMPP 3.4. */
    public static byte[] encode(SmppPdu pdu) {
        return encode(pdu, true);
    }

    /**
     * Encodes one PDU. Error responses to bind_transmitter, bind_receiver and submit_sm have no body (4.1.2, 4.1.4,
     * 4.4.2); that to bind_transceiver has one, because gosmpp reads it.
     *
     * @param withParameters true if the peer accepts optional parameters
     */
    public static byte[] encode(SmppPdu pdu, boolean withParameters) {
        SmppWriter out = new SmppWriter(withParameters);
        boolean isResponse = pdu instanceof SmppPdu.Response;
        int status = pdu instanceof SmppPdu.Response response ? response.status() : SmppStatus.OK;
        out.fourOctets("command_length", 0);
        out.fourOctets("command_id", pdu.command().code() | (isResponse ? SmppCommand.RESPONSE : 0));
        out.fourOctets("command_status", status);
        out.fourOctets("sequence_number", pdu.sequence());
        if (status == SmppStatus.OK || !WITHOUT_BODY_ON_ERRORS.contains(pdu.command())) {
            try {
                body(out, pdu);
            } catch (SmppViolation violation) {
                throw new IllegalArgumentException(pdu + ": " + violation.getMessage(), violation);
            }
        }
        return out.toArray();
    }

    /** The response that refuses a request. */
    public static SmppPdu refusal(SmppPdu request, int status) {
        return request instanceof SmppPdu.Query query
                ? new SmppPdu.QueryResponse(status, query.sequence(), query.messageId(), "", UNKNOWN, 0)
                : response(request.command(), status, request.sequence());
    }

    /** A request without content. */
    private static SmppPdu request(SmppCommand command, int sequence) {
        return switch (command) {
            case BIND_RECEIVER, BIND_TRANSMITTER, BIND_TRANSCEIVER ->
                new SmppPdu.Bind(command, sequence, "", "", "", 0, "");
            case SUBMIT_SM, DELIVER_SM, DATA_SM -> new SmppPdu.Message(command, sequence, EMPTY);
            case SUBMIT_MULTI -> new SmppPdu.SubmitMulti(sequence, EMPTY, List.of());
            case QUERY_SM -> new SmppPdu.Query(sequence, "", SmppAddress.NONE);
            case CANCEL_SM -> new SmppPdu.Cancel(sequence, "", "", SmppAddress.NONE, SmppAddress.NONE);
            case REPLACE_SM -> new SmppPdu.Replace(sequence, "", SmppAddress.NONE, "", "", 0, 0, NOTHING);
            case ENQUIRE_LINK, UNBIND, GENERIC_NACK -> new SmppPdu.Plain(command, sequence);
        };
    }

    /** A response without content. */
    private static SmppPdu.Response response(SmppCommand command, int status, int sequence) {
        return switch (command) {
            case BIND_RECEIVER, BIND_TRANSMITTER, BIND_TRANSCEIVER ->
                new SmppPdu.BindResponse(command, status, sequence, "");
            case SUBMIT_SM, DELIVER_SM, DATA_SM -> new SmppPdu.MessageResponse(command, status, sequence, "");
            case GENERIC_NACK -> new SmppPdu.GenericNack(status, sequence);
            case SUBMIT_MULTI -> new SmppPdu.SubmitMultiResponse(status, sequence, "", List.of());
            case QUERY_SM -> new SmppPdu.QueryResponse(status, sequence, "", "", UNKNOWN, 0);
            case CANCEL_SM, REPLACE_SM, ENQUIRE_LINK, UNBIND -> new SmppPdu.PlainResponse(command, status, sequence);
        };
    }

    private static SmppPdu body(SmppFields fields, SmppPdu pdu) throws SmppViolation {
        if (pdu instanceof SmppPdu.Message message) {
            boolean isData = message.command() == SmppCommand.DATA_SM;
            SmppMessage content = isData ? data(fields, message.message()) : message(fields, message.message());
            return new SmppPdu.Message(message.command(), message.sequence(), content);
        } else if (pdu instanceof SmppPdu.MessageResponse response) {
            return new SmppPdu.MessageResponse(
                    response.command(),
                    response.status(),
                    response.sequence(),
                    messageId(fields, response.messageId()));
        } else if (pdu instanceof SmppPdu.SubmitMulti multi) {
            return submitMulti(fields, multi);
        } else if (pdu instanceof SmppPdu.SubmitMultiResponse response) {
            return submitMultiResponse(fields, response);
        } else if (pdu instanceof SmppPdu.Bind bind) {
            return bind(fields, bind);
        } else if (pdu instanceof SmppPdu.BindResponse response) {
            String systemId =
                    fields.text("system_id", MAX_MESSAGE_ID, SmppStatus.INVALID_COMMAND_LENGTH, response.systemId());
            fields.parameters(List.of(Tlv.ofOctet(Tlv.INTERFACE_VERSION, INTERFACE_VERSION)));
            return new SmppPdu.BindResponse(response.command(), response.status(), response.sequence(), systemId);
        }
        return bodyOnMessages(fields, pdu);
    }

    /** The body of a PDU that names a submitted message; other kinds have none. */
    private static SmppPdu bodyOnMessages(SmppFields fields, SmppPdu pdu) throws SmppViolation {
        if (pdu instanceof SmppPdu.Query query) {
            return new SmppPdu.Query(
                    query.sequence(),
                    messageId(fields, query.messageId()),
                    source(fields, MAX_ADDRESS, query.source()));
        } else if (pdu instanceof SmppPdu.QueryResponse response) {
            return new SmppPdu.QueryResponse(
                    response.status(),
                    response.sequence(),
                    messageId(fields, response.messageId()),
                    fields.text("final_date", MAX_TIME, SmppStatus.INVALID_COMMAND_LENGTH, response.finalDate()),
                    fields.octet("message_state", response.state()),
                    fields.octet("error_code", response.error()));
        } else if (pdu instanceof SmppPdu.Cancel cancel) {
            String serviceType = serviceType(fields, cancel.serviceType());
            return new SmppPdu.Cancel(
                    cancel.sequence(),
                    serviceType,
                    messageId(fields, cancel.messageId()),
                    source(fields, MAX_ADDRESS, cancel.source()),
                    destination(fields, MAX_ADDRESS, cancel.destination()));
        } else if (pdu instanceof SmppPdu.Replace replace) {
            return new SmppPdu.Replace(
                    replace.sequence(),
                    messageId(fields, replace.messageId()),
                    source(fields, MAX_ADDRESS, replace.source()),
                    schedule(fields, replace.schedule()),
                    validity(fields, replace.validity()),
                    fields.octet("registered_delivery", replace.registeredDelivery()),
                    defaultMessage(fields, replace.defaultMessageId()),
                    fields.shortMessage(replace.shortMessage()));
        }
        return pdu;
    }

    private static SmppPdu bind(SmppFields fields, SmppPdu.Bind bind) throws SmppViolation {
        String systemId = fields.text("system_id", MAX_SYSTEM_ID, SmppStatus.INVALID_SYSTEM_ID, bind.systemId());
        String password = fields.text("password", MAX_PASSWORD, SmppStatus.INVALID_PASSWORD, bind.password());
        String type = fields.text("system_type", MAX_SYSTEM_TYPE, SmppStatus.INVALID_SYSTEM_TYPE, bind.systemType());
        int version = fields.octet("interface_version", bind.interfaceVersion());
        SmppAddress types = new SmppAddress(fields.octet("addr_ton", 0), fields.octet("addr_npi", 0), "");
        if (version > INTERFACE_VERSION && version != SMPP_5 || types.check(1, 1) != SmppStatus.OK) {
            throw new SmppViolation(
                    SmppStatus.BIND_FAILED, "interface_version " + version + " or " + types + " is not known");
        }
        String range = fields.text("address_range", MAX_ADDRESS_RANGE, SmppStatus.BIND_FAILED, bind.addressRange());
        return new SmppPdu.Bind(bind.command(), bind.sequence(), systemId, password, type, version, range);
    }

    /** submit_sm and deliver_sm. */
    private static SmppMessage message(SmppFields fields, SmppMessage message) throws SmppViolation {
        String serviceType = serviceType(fields, message.serviceType());
        SmppAddress source = source(fields, MAX_ADDRESS, message.source());
        SmppAddress destination = destination(fields, MAX_ADDRESS, message.destination());
        return fromEsmClass(fields, serviceType, source, destination, message);
    }

    private static SmppPdu submitMulti(SmppFields fields, SmppPdu.SubmitMulti multi) throws SmppViolation {
        SmppMessage message = multi.message();
        String serviceType = serviceType(fields, message.serviceType());
        SmppAddress source = source(fields, MAX_ADDRESS, message.source());
        int count = fields.octet("number_of_dests", multi.destinations().size());
        if (count == 0 || count > MAX_DESTINATIONS) {
            throw new SmppViolation(
                    SmppStatus.INVALID_NUMBER_OF_DESTINATIONS, count + " destinations, expected 1 to 254");
        }
        List<SmppAddress> destinations = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            int flag = fields.octet("dest_flag", ADDRESS_FLAG);
            if (flag != ADDRESS_FLAG) {
                int status =
                        flag == LIST_FLAG ? SmppStatus.INVALID_DISTRIBUTION_LIST : SmppStatus.INVALID_DESTINATION_FLAG;
                throw new SmppViolation(status, "dest_flag " + flag + ", expected 1, an address");
            }
            boolean isGiven = i < multi.destinations().size();
            destinations.add(destination(
                    fields, MAX_ADDRESS, isGiven ? multi.destinations().get(i) : SmppAddress.NONE));
        }
        return new SmppPdu.SubmitMulti(
                multi.sequence(), fromEsmClass(fields, serviceType, source, SmppAddress.NONE, message), destinations);
    }

    private static SmppPdu submitMultiResponse(SmppFields fields, SmppPdu.SubmitMultiResponse response)
            throws SmppViolation {
        String messageId = messageId(fields, response.messageId());
        int count = fields.octet("no_unsuccess", response.refused().size());
        List<SmppPdu.Refused> refused = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            boolean isGiven = i < response.refused().size();
            SmppPdu.Refused each =
                    isGiven ? response.refused().get(i) : new SmppPdu.Refused(SmppAddress.NONE, SmppStatus.OK);
            refused.add(new SmppPdu.Refused(
                    destination(fields, MAX_ADDRESS, each.destination()),
                    fields.fourOctets("error_status_code", each.status())));
        }
        return new SmppPdu.SubmitMultiResponse(response.status(), response.sequence(), messageId, refused);
    }

    /** The last fields of submit_sm, deliver_sm and submit_multi. */
    private static SmppMessage fromEsmClass(
            SmppFields fields, String serviceType, SmppAddress source, SmppAddress destination, SmppMessage message)
            throws SmppViolation {
        return new SmppMessage(
                serviceType,
                source,
                destination,
                fields.octet("esm_class", message.esmClass()),
                fields.octet("protocol_id", message.protocolId()),
                fields.octet("priority_flag", message.priority(), MAX_PRIORITY, SmppStatus.INVALID_PRIORITY),
                schedule(fields, message.schedule()),
                validity(fields, message.validity()),
                fields.octet("registered_delivery", message.registeredDelivery()),
                fields.octet(
                        "replace_if_present_flag",
                        message.replaceIfPresent(),
                        REPLACE,
                        SmppStatus.INVALID_REPLACE_FLAG),
                fields.octet("data_coding", message.dataCoding()),
                defaultMessage(fields, message.defaultMessageId()),
                fields.shortMessage(message.shortMessage()),
                fields.parameters(message.parameters()));
    }

    private static SmppMessage data(SmppFields fields, SmppMessage message) throws SmppViolation {
        String serviceType = serviceType(fields, message.serviceType());
        SmppAddress source = source(fields, MAX_DATA_ADDRESS, message.source());
        SmppAddress destination = destination(fields, MAX_DATA_ADDRESS, message.destination());
        int esmClass = fields.octet("esm_class", message.esmClass());
        int registeredDelivery = fields.octet("registered_delivery", message.registeredDelivery());
        int dataCoding = fields.octet("data_coding", message.dataCoding());
        List<Tlv> parameters = fields.parameters(message.parameters());
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
                NOTHING,
                parameters);
    }

    private static int defaultMessage(SmppFields fields, int value) throws SmppViolation {
        return fields.octet("sm_default_msg_id", value, NO_DEFAULT_MESSAGE, SmppStatus.INVALID_DEFAULT_MESSAGE);
    }

    private static String serviceType(SmppFields fields, String value) throws SmppViolation {
        return fields.text("service_type", MAX_SERVICE_TYPE, SmppStatus.INVALID_SERVICE_TYPE, value);
    }

    private static String messageId(SmppFields fields, String value) throws SmppViolation {
        return fields.text("message_id", MAX_MESSAGE_ID, SmppStatus.INVALID_MESSAGE_ID, value);
    }

    private static String schedule(SmppFields fields, String value) throws SmppViolation {
        return fields.text("schedule_delivery_time", MAX_TIME, SmppStatus.INVALID_SCHEDULE, value);
    }

    private static String validity(SmppFields fields, String value) throws SmppViolation {
        return fields.text("validity_period", MAX_TIME, SmppStatus.INVALID_VALIDITY, value);
    }

    private static SmppAddress source(SmppFields fields, int most, SmppAddress value) throws SmppViolation {
        return address(fields, "source_addr", most, SmppStatus.INVALID_SOURCE, value);
    }

    private static SmppAddress destination(SmppFields fields, int most, SmppAddress value) throws SmppViolation {
        return address(fields, "destination_addr", most, SmppStatus.INVALID_DESTINATION, value);
    }

    private static SmppAddress address(SmppFields fields, String field, int most, int status, SmppAddress value)
            throws SmppViolation {
        return new SmppAddress(
                fields.octet(field + "_ton", value.ton()),
                fields.octet(field + "_npi", value.npi()),
                fields.text(field, most, status, value.value()));
    }
}
