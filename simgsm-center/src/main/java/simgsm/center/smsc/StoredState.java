package simgsm.center.smsc;

import java.util.List;

/**
 * The content of a store at the centre's start.
 *
 * @param lastId the highest message id used; 0 if none
 * @param waiting accepted messages that have not ended, by id
 * @param unreported ended messages with a pending report, by id
 * @param recent recently accepted messages, in any state; oldest first
 * @param subscribers all subscribers who have ever registered
 */
public record StoredState(
        long lastId,
        List<ShortMessage> waiting,
        List<Unreported> unreported,
        List<ShortMessage> recent,
        List<StoreEntry.Known> subscribers) {
    /** The content of a new store. */
    public static final StoredState EMPTY = new StoredState(0, List.of(), List.of(), List.of(), List.of());

    public record Unreported(ShortMessage message, StoreEntry.Ended ended) {}
}
