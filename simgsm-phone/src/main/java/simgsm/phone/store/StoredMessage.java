package simgsm.phone.store;

import java.time.Instant;
import java.util.Optional;
import simgsm.air.RpCause;
import simgsm.event.EventLine;

/**
 * A message in one of the phone's folders.
 *
 * <p>As a line: answer to {@code inbox}.
 *
 * @param serial permanent identifier within the phone
 * @param party number or alphanumeric address of the sender or receiver; for a broadcast its channel
 * @param at time of reception or submission
 * @param id of a submitted message in the station's events; else 0
 * @param parts number of short messages or pages
 * @param cause of a failure
 */
@EventLine("message from=party text= read=")
public record StoredMessage(
        int serial,
        String party,
        String text,
        Instant at,
        boolean read,
        Delivery delivery,
        int id,
        int parts,
        Optional<RpCause> cause) {
    /** The id of messages unknown to the station. */
    static final int NO_ID = -1;

    /** The progress of a message. */
    public enum Delivery {
        RECEIVED,
        /** Not submitted yet. */
        DRAFT,
        SENDING,
        /** Acknowledged by the network. */
        SENT,
        /** Delivered to the receiver. */
        DELIVERED,
        FAILED
    }

    /** True if a further report may follow. */
    boolean isOpen() {
        return delivery == Delivery.SENDING || delivery == Delivery.SENT;
    }

    StoredMessage seen() {
        return new StoredMessage(serial, party, text, at, true, delivery, id, parts, cause);
    }

    StoredMessage advanced(Delivery next, int knownParts) {
        return new StoredMessage(serial, party, text, at, read, next, id, knownParts, cause);
    }

    StoredMessage failed(RpCause newCause) {
        return new StoredMessage(serial, party, text, at, read, Delivery.FAILED, id, parts, Optional.of(newCause));
    }
}
