package simgsm.center.smsc;

/** Where messages rest: in memory, or in a journal on disk. */
public interface MessageStore {
    /** The ticket of what nobody waits for. */
    long NO_TICKET = 0;

    /**
     * Begins to make an entry durable and returns at once. When it is, or when it cannot be, the store posts ticket and
     * outcome back to the thread that drives the exchange: in the order of the calls, exactly once each, and never from
     * inside this call.
     */
    void commit(long ticket, StoreEntry entry);
}
