package simgsm.center.smsc;

import java.time.Instant;

/** What a store is asked to keep, in the order in which it happened. */
public sealed interface StoreEntry {
    /** A message that will be acknowledged to its sender once this entry is durable. */
    record Accepted(ShortMessage message) implements StoreEntry {}

    /** A message that need not be kept any longer. */
    record Ended(long id, MessageState state, Instant at) implements StoreEntry {}
}
