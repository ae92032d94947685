package simgsm.center.smpp;

/** Protocol data units (4), each with the sequence_number that a response shares with its request. */
public sealed interface SmppPdu {
    int sequence();

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
    record BindResponse(SmppCommand command, int status, int sequence, String systemId) implements SmppPdu {}

    /** @param command submit_sm, deliver_sm or data_sm */
    record Message(SmppCommand command, int sequence, SmppMessage message) implements SmppPdu {}

    /** @param messageId empty in deliver_sm_resp; sent with status 0 only */
    record MessageResponse(SmppCommand command, int status, int sequence, String messageId) implements SmppPdu {}

    record Query(int sequence, String messageId, SmppAddress source) implements SmppPdu {}

    /** @param finalDate 16 characters; empty before the message has ended */
    record QueryResponse(int status, int sequence, String messageId, String finalDate, int state, int error)
            implements SmppPdu {}

    record Cancel(int sequence, String messageId, SmppAddress source, SmppAddress destination) implements SmppPdu {}

    /** enquire_link or unbind. */
    record Plain(SmppCommand command, int sequence) implements SmppPdu {}

    /** The response to those and to cancel_sm, and any response without a body. */
    record PlainResponse(SmppCommand command, int status, int sequence) implements SmppPdu {}

    record GenericNack(int status, int sequence) implements SmppPdu {}
}
