package simgsm.center.smsc;

import java.time.Instant;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;

/** A stored event, in the order of occurrence. */
public sealed interface StoreEntry {
    /**
     * A message, or the new content of the one with this id; its sender gets the acknowledgement once this entry is
     * durable.
     */
    record Accepted(ShortMessage message) implements StoreEntry {}

    /**
     * The final state of a message.
     *
     * @param reportFollows true if a report to the sender is due, so that the message is kept until {@link Reported}
     */
    record Ended(long id, MessageState state, Instant at, boolean reportFollows) implements StoreEntry {}

    /** The report on an ended message was delivered, or has ended; the message is no longer needed. */
    record Reported(long id) implements StoreEntry {}

    /**
     * A subscriber's first registration, or a change of services.
     *
     * @param services call forwarding and call waiting, in the format of the subscriber's register
     */
    record Known(Msisdn number, Imsi imsi, String services) implements StoreEntry {
        public Known(Msisdn number, Imsi imsi) {
            this(number, imsi, "");
        }
    }

    /** Message ids up to this one are used. */
    record Numbered(long lastId) implements StoreEntry {}
}
