package simgsm.center.smsc;

import java.util.List;

/**
 * What a store has kept of the centre's earlier lives.
 *
 * @param lastId the highest message id ever given; 0 if none
 * @param waiting messages that were accepted and have not ended, by id
 * @param unreported messages that have ended and whose senders are still to be told, by id
 * @param recent what was lately accepted, whatever became of it; oldest first
 * @param subscribers everybody who has ever registered
 */
public record Restored(
        long lastId,
        List<ShortMessage> waiting,
        List<Unreported> unreported,
        List<ShortMessage> recent,
        List<StoreEntry.Known> subscribers) {
    /** The first life. */
    public static final Restored NOTHING = new Restored(0, List.of(), List.of(), List.of(), List.of());

    public record Unreported(ShortMessage message, StoreEntry.Ended ended) {}
}
