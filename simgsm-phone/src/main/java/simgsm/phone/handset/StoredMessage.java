package simgsm.phone.handset;

import java.time.Instant;
import java.util.Optional;
import simgsm.air.RpCause;

/**
 * A message in one of the phone's boxes.
 *
 * @param party who sent it or is to get it: a number, or a name where the sender has one; for a broadcast its channel
 * @param at when it came or was handed in
 * @param id message reference of the first part, of sent ones
 * @param parts how many short messages, or pages, it took
 * @param cause why it failed, if it has
 */
public record StoredMessage(
        String party,
        String text,
        Instant at,
        boolean read,
        Delivery delivery,
        int id,
        int parts,
        Optional<RpCause> cause) {
    /** How far a message has got. */
    public enum Delivery {
        RECEIVED,
        SENDING,
        /** The network has it. */
        SENT,
        /** The receiver has it. */
        DELIVERED,
        FAILED
    }

    StoredMessage seen() {
        return new StoredMessage(party, text, at, true, delivery, id, parts, cause);
    }

    StoredMessage advanced(Delivery next, int knownParts) {
        return new StoredMessage(party, text, at, read, next, id, knownParts, cause);
    }

    StoredMessage failed(RpCause why) {
        return new StoredMessage(party, text, at, read, Delivery.FAILED, id, parts, Optional.of(why));
    }
}
