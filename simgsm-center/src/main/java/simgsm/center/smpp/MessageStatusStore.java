package simgsm.center.smpp;

import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import simgsm.center.smsc.BoundedMap;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.ShortMessageCenter;

/** States of the messages that applications sent, for query_sm and cancel_sm: all that wait, and the last that ended. */
final class MessageStatusStore {
    static final int MAX_ENDED = 100_000;

    /** @param at when the message ended; while it waits, when it was accepted */
    record MessageStatus(long id, String systemId, String source, MessageState state, Instant at) {
        private static MessageStatus of(ShortMessage message, EsmeOrigin origin, MessageState state, Instant at) {
            return new MessageStatus(
                    message.id(), origin.systemId(), origin.source().value(), state, at);
        }
    }

    private final Map<Long, MessageStatus> ended = new BoundedMap<>(MAX_ENDED);

    /** Takes note of a new state. */
    void changed(ShortMessage message, MessageState state, Instant now) {
        if (message.esme().isPresent() && state != MessageState.ACCEPTED) {
            ended.put(message.id(), MessageStatus.of(message, message.esme().get(), state, now));
        }
    }

    /**
     * The status of a message.
     *
     * @param systemId must have sent it
     * @param source must be its source address; empty fits every address
     */
    Optional<MessageStatus> find(ShortMessageCenter center, String id, String systemId, String source) {
        long number;
        try {
            number = Long.parseLong(id);
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
        String plainSource = source.startsWith("+") ? source.substring(1) : source;
        return Optional.ofNullable(ended.get(number))
                .or(() -> center.messages()
                        .waitingMessage(number)
                        .flatMap(message -> message.esme()
                                .map(origin -> MessageStatus.of(
                                        message, origin, MessageState.ACCEPTED, message.acceptedAt()))))
                .filter(status -> status.systemId.equals(systemId))
                .filter(status -> plainSource.isEmpty() || plainSource.equals(status.source));
    }
}
