package simgsm.phone;

import java.util.function.Function;
import simgsm.phone.handset.Handset;

/** The console's access to the handset, owned by another thread. */
interface HandsetAccess {
    /**
     * Runs an action on the owner thread and waits for its result.
     *
     * @throws IllegalStateException if the action fails or has not ended within 5 s
     */
    <T> T ask(Function<Handset, T> action) throws InterruptedException;

    /**
     * Waits, up to the limit, until queued keys are sent and messages acknowledged.
     *
     * @return false at the limit
     */
    boolean settle(long limitNanos) throws InterruptedException;
}
