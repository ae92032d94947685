package simgsm.smpp;

import java.util.List;
import simgsm.octets.OctetString;

/** Protocol data units (4), each with the sequence_number that a response shares with its request. */
public sealed interface SmppPdu {
    SmppCommand command();

    int sequence();

    /** A response, or generic_nack. */
    sealed interface Response extends SmppPdu {
        /** One of {@link SmppStatus}. */
        int status();
    }

    /** bind_receiver, bind_transmitter, bind_transceiver. */
    record Bind(
            SmppCommand command,
            int sequence,
            String systemId,
            String password,
            String systemType,
            int interfaceVersion,
            String addressRange)
            implements SmppPdu {
        public Bind {
            if (!command.isBind()) {
                throw new IllegalArgumentException(command + " binds nothing");
            }
        }
    }

    /** @param systemId of the centre; sent with status 0 only */
    record BindResponse(SmppCommand command, int status, int sequence, String systemId) implements Response {}

    /** @param command submit_sm, deliver_sm or data_sm */
    record Message(SmppCommand command, int sequence, SmppMessage message) implements SmppPdu {}

    /** @param messageId empty in deliver_sm_resp and on an error */
    record MessageResponse(SmppCommand command, int status, int sequence, String messageId) implements Response {}

    /** @param message its destination is not used */
    record SubmitMulti(int sequence, SmppMessage message, List<SmppAddress> destinations) implements SmppPdu {
        @Override
        public SmppCommand command() {
            return SmppCommand.SUBMIT_MULTI;
        }
    }

    /** @param refused the destinations without a submission */
    record SubmitMultiResponse(int status, int sequence, String messageId, List<Refused> refused) implements Response {
        @Override
        public SmppCommand command() {
            return SmppCommand.SUBMIT_MULTI;
        }
    }

    /** unsuccess_sme (4.5.2). */
    record Refused(SmppAddress destination, int status) {}

    record Query(int sequence, String messageId, SmppAddress source) implements SmppPdu {
        @Override
        public SmppCommand command() {
            return SmppCommand.QUERY_SM;
        }
    }

    /** @param finalDate 16 characters; empty before the message's end */
    record QueryResponse(int status, int sequence, String messageId, String finalDate, int state, int error)
            implements Response {
        @Override
        public SmppCommand command() {
            return SmppCommand.QUERY_SM;
        }
    }

    /**
     * cancel_sm (4.9.1).
     *
     * @param serviceType empty for any; ignored with an id
     * @param messageId empty: all messages from this source to this destination
     */
    record Cancel(int sequence, String serviceType, String messageId, SmppAddress source, SmppAddress destination)
            implements SmppPdu {
        @Override
        public SmppCommand command() {
            return SmppCommand.CANCEL_SM;
        }
    }

    /**
     * replace_sm (4.10.1).
     *
     * @param schedule empty: unchanged
     * @param validity empty: unchanged
     */
    record Replace(
            int sequence,
            String messageId,
            SmppAddress source,
            String schedule,
            String validity,
            int registeredDelivery,
            int defaultMessageId,
            OctetString shortMessage)
            implements SmppPdu {
        @Override
        public SmppCommand command() {
            return SmppCommand.REPLACE_SM;
        }
    }

    /** enquire_link or unbind. */
    record Plain(SmppCommand command, int sequence) implements SmppPdu {}

    /** The response to enquire_link, unbind, cancel_sm and replace_sm. */
    record PlainResponse(SmppCommand command, int status, int sequence) implements Response {}

    record GenericNack(int status, int sequence) implements Response {
        @Override
        public SmppCommand command() {
            return SmppCommand.GENERIC_NACK;
        }
    }
}
