package simgsm.center.smpp;

import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.HeapShare;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.timer.BoundedMap;

/**
 * States of the messages that applications sent, for query_sm and similar: all waiting ones, and the last ended ones.
 */
final class MessageStatusStore {
    /** Maximum of ended messages, 200 octets each. */
    static final int MAX_ENDED = HeapShare.count(100_000, 200);

    /**
     * The status of one message, or of all messages of a submission.
     *
     * @param id of the last message of the submission
     * @param firstId of the first one
     * @param state ACCEPTED while one of them waits; then DELIVERED, or the state of the first undelivered one
     * @param at end of the last one; while one waits, its acceptance
     */
    record MessageStatus(long id, long firstId, String systemId, String source, MessageState state, Instant at) {
        private static MessageStatus of(ShortMessage message, EsmeOrigin origin, MessageState state, Instant at) {
            return new MessageStatus(
                    message.submissionId(),
                    message.id() - origin.group().before(),
                    origin.systemId(),
                    origin.source().value(),
                    state,
                    at);
        }

        private MessageStatus and(MessageStatus further) {
            boolean isFurtherWorse = further.state == MessageState.ACCEPTED
                    || state == MessageState.DELIVERED && further.state != MessageState.DELIVERED;
            Instant later = further.at.isAfter(at) ? further.at : at;
            return state == MessageState.ACCEPTED
                    ? this
                    : new MessageStatus(id, firstId, systemId, source, isFurtherWorse ? further.state : state, later);
        }
    }

    private final Map<Long, MessageStatus> ended = new BoundedMap<>(MAX_ENDED);

    /** Stores a new state. */
    void changed(ShortMessage message, MessageState state, Instant now) {
        if (message.esme().isPresent() && state != MessageState.ACCEPTED) {
            ended.put(message.id(), MessageStatus.of(message, message.esme().get(), state, now));
        }
    }

    /**
     * The status of a submission.
     *
     * @param id as known to the application
     * @param systemId must have sent it
     * @param source must be its source address; empty matches every address
     */
    Optional<MessageStatus> find(ShortMessageCenter center, String id, String systemId, String source) {
        long number;
        try {
            number = Long.parseLong(id);
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
        String plainSource = source.startsWith("+") ? source.substring(1) : source;
        return find(center, number)
                .filter(status -> status.id == number && status.systemId.equals(systemId))
                .filter(status -> plainSource.isEmpty() || plainSource.equals(status.source))
                .map(status -> ofSubmission(center, status));
    }

    private Optional<MessageStatus> find(ShortMessageCenter center, long id) {
        return Optional.ofNullable(ended.get(id))
                .or(() -> center.messages()
                        .waitingMessage(id)
                        .flatMap(message -> message.esme()
                                .map(origin -> MessageStatus.of(
                                        message, origin, MessageState.ACCEPTED, message.acceptedAt()))));
    }

    /** Combines the messages of a submission, at most {@link MessageRequests#MAX_MESSAGES}. */
    private MessageStatus ofSubmission(ShortMessageCenter center, MessageStatus last) {
        MessageStatus all = last;
        for (long id = last.firstId; id < last.id; id++) {
            all = find(center, id).map(all::and).orElse(all);
        }
        return all;
    }
}
