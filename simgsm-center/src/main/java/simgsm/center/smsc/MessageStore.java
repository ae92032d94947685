package simgsm.center.smsc;

import java.util.List;

/** Keeps messages: in memory, or in a journal on disk. */
public interface MessageStore {
    /** Ticket of a commit whose outcome is not used. */
    long NO_TICKET = 0;

    /**
     * Begins to make entries durable, all or none, and returns at once. The store posts ticket and outcome to the
     * thread that drives the exchange: in the order of the calls, exactly once each, and never during this call.
     */
    void commit(long ticket, List<StoreEntry> entries);
}
