package simgsm.center.smsc;

import java.time.Instant;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;

/** What a store is asked to keep, in the order in which it happened. */
public sealed interface StoreEntry {
    /** A message that will be acknowledged to its sender once this entry is durable. */
    record Accepted(ShortMessage message) implements StoreEntry {}

    /**
     * What has become of a message.
     *
     * @param reportFollows whether its sender is still to be told, so that the message must be kept until {@link Reported}
     */
    record Ended(long id, MessageState state, Instant at, boolean reportFollows) implements StoreEntry {}

    /** The sender of an ended message has been told, or cannot be; the message need not be kept any longer. */
    record Reported(long id) implements StoreEntry {}

    /** A subscriber who has registered for the first time. */
    record Known(Msisdn number, Imsi imsi) implements StoreEntry {}

    /** Message ids up to this one have been given. */
    record Numbered(long lastId) implements StoreEntry {}
}
