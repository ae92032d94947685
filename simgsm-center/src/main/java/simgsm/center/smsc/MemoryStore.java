package simgsm.center.smsc;

import java.util.function.LongConsumer;

/** Keeps nothing beyond what the centre itself holds; messages live as long as the process. */
public final class MemoryStore implements MessageStore {
    private final LongConsumer posted;

    /** @param posted takes each ticket and hands it to the exchange later, from its own thread's queue */
    public MemoryStore(LongConsumer posted) {
        this.posted = posted;
    }

    @Override
    public void commit(long ticket, StoreEntry entry) {
        posted.accept(ticket);
    }
}
