package simgsm.center.smpp;

import simgsm.octets.OctetWriter;

/** Encodes PDUs. */
final class SmppEncoder {
    private SmppEncoder() {}

    static byte[] encode(SmppPdu pdu) {
        OctetWriter out = new OctetWriter();
        if (pdu instanceof SmppPdu.Message message) {
            request(out, message.command(), message.sequence());
            write(out, message);
        } else if (pdu instanceof SmppPdu.MessageResponse response) {
            response(out, response.command(), response.status(), response.sequence());
            if (response.status() == SmppStatus.OK) {
                out.zeroEnded(response.messageId());
            }
        } else if (pdu instanceof SmppPdu.BindResponse response) {
            response(out, response.command(), response.status(), response.sequence());
            if (response.status() == SmppStatus.OK) {
                out.zeroEnded(response.systemId());
                write(out, Tlv.ofOctet(Tlv.INTERFACE_VERSION, SmppServer.INTERFACE_VERSION));
            }
        } else if (pdu instanceof SmppPdu.QueryResponse response) {
            response(out, SmppCommand.QUERY_SM, response.status(), response.sequence());
            out.zeroEnded(response.messageId());
            out.zeroEnded(response.finalDate());
            out.octet(response.state()).octet(response.error());
        } else if (pdu instanceof SmppPdu.Plain plain) {
            request(out, plain.command(), plain.sequence());
        } else if (pdu instanceof SmppPdu.PlainResponse response) {
            response(out, response.command(), response.status(), response.sequence());
        } else if (pdu instanceof SmppPdu.GenericNack nack) {
            header(out, SmppCommand.RESPONSE, nack.status(), nack.sequence());
        } else {
            writeOfApplications(out, pdu);
        }
        return withLength(out.toArray());
    }

    /** PDUs that only applications send. */
    private static void writeOfApplications(OctetWriter out, SmppPdu pdu) {
        if (pdu instanceof SmppPdu.Bind bind) {
            request(out, bind.command(), bind.sequence());
            out.zeroEnded(bind.systemId());
            out.zeroEnded(bind.password());
            out.zeroEnded(bind.systemType());
            out.octet(bind.interfaceVersion()).octet(0).octet(0);
            out.zeroEnded(bind.addressRange());
        } else if (pdu instanceof SmppPdu.Query query) {
            request(out, SmppCommand.QUERY_SM, query.sequence());
            out.zeroEnded(query.messageId());
            write(out, query.source());
        } else if (pdu instanceof SmppPdu.Cancel cancel) {
            request(out, SmppCommand.CANCEL_SM, cancel.sequence());
            out.zeroEnded("");
            out.zeroEnded(cancel.messageId());
            write(out, cancel.source());
            write(out, cancel.destination());
        }
    }

    private static void request(OctetWriter out, SmppCommand command, int sequence) {
        header(out, command.code(), SmppStatus.OK, sequence);
    }

    private static void response(OctetWriter out, SmppCommand command, int status, int sequence) {
        header(out, command.code() | SmppCommand.RESPONSE, status, sequence);
    }

    private static void header(OctetWriter out, int id, int status, int sequence) {
        out.fourOctets(0).fourOctets(id).fourOctets(status).fourOctets(sequence);
    }

    private static byte[] withLength(byte[] octets) {
        for (int i = 0; i < 4; i++) {
            octets[i] = (byte) (octets.length >> 8 * (3 - i));
        }
        return octets;
    }

    private static void write(OctetWriter out, SmppPdu.Message pdu) {
        SmppMessage message = pdu.message();
        out.zeroEnded(message.serviceType());
        write(out, message.source());
        write(out, message.destination());
        out.octet(message.esmClass());
        if (pdu.command() == SmppCommand.DATA_SM) {
            out.octet(message.registeredDelivery()).octet(message.dataCoding());
        } else {
            out.octet(message.protocolId()).octet(message.priority());
            out.zeroEnded(message.schedule());
            out.zeroEnded(message.validity());
            out.octet(message.registeredDelivery()).octet(message.replaceIfPresent());
            out.octet(message.dataCoding()).octet(message.defaultMessageId());
            out.octet(message.shortMessage().length()).string(message.shortMessage());
        }
        for (Tlv parameter : message.parameters()) {
            write(out, parameter);
        }
    }

    private static void write(OctetWriter out, SmppAddress address) {
        out.octet(address.ton()).octet(address.npi());
        out.zeroEnded(address.value());
    }

    private static void write(OctetWriter out, Tlv parameter) {
        out.twoOctets(parameter.tag()).twoOctets(parameter.value().length()).string(parameter.value());
    }
}
