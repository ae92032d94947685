package simgsm.station.call;

import java.util.HashSet;
import java.util.Set;
import simgsm.air.TransactionIdentifier;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;

/** Calls held by the other party, by their transactions as in the messages sent. */
final class PeerHolds {
    private final StationContext context;
    private final Set<TransactionIdentifier> held = new HashSet<>();

    PeerHolds(StationContext context) {
        this.context = context;
    }

    /** The other party holds or retrieves a call; a change of the current call is reported. */
    void told(TransactionIdentifier transaction, boolean onHold, boolean isCurrent) {
        boolean isNew = onHold ? held.add(transaction) : held.remove(transaction);
        if (isNew && isCurrent) {
            context.events().add(onHold ? new StationEvent.HeldByPeer() : new StationEvent.RetrievedByPeer());
        }
    }

    /** The call becomes the current one. */
    void reportOnTake(TransactionIdentifier transaction) {
        if (held.contains(transaction)) {
            context.events().add(new StationEvent.HeldByPeer());
        }
    }

    void ended(TransactionIdentifier transaction) {
        held.remove(transaction);
    }
}
