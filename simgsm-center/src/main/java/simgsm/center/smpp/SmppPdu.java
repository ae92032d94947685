package simgsm.center.smpp;

/** One protocol data unit (4). Every record holds the sequence number that joins request and answer. */
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

    /** @param systemId of the centre; not sent with a status other than 0 */
    record BindResponse(SmppCommand command, int status, int sequence, String systemId) implements SmppPdu {}

    /** @param command submit_sm, deliver_sm or data_sm */
    record Message(SmppCommand command, int sequence, SmppMessage message) implements SmppPdu {}

    /** @param messageId empty in the answer to deliver_sm; not sent with a status other than 0 */
    record MessageResponse(SmppCommand command, int status, int sequence, String messageId) implements SmppPdu {}

    record Query(int sequence, String messageId, SmppAddress source) implements SmppPdu {}

    /** @param finalDate 16 characters, empty while the message is under way */
    record QueryResponse(int status, int sequence, String messageId, String finalDate, int state, int error)
            implements SmppPdu {}

    record Cancel(int sequence, String messageId, SmppAddress source, SmppAddress destination) implements SmppPdu {}

    /** enquire_link or unbind. */
    record Plain(SmppCommand command, int sequence) implements SmppPdu {}

    /** The answer to those and to cancel_sm; also any answer of which only the status is of interest. */
    record PlainResponse(SmppCommand command, int status, int sequence) implements SmppPdu {}

    record GenericNack(int status, int sequence) implements SmppPdu {}
}
