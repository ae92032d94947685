package simgsm.phone;

import java.util.function.Function;
import simgsm.phone.handset.Handset;

/** How the console reaches the handset, which another thread owns. */
interface HandsetAccess {
    /** Has the owner thread do something and waits for its result. */
    <T> T ask(Function<Handset, T> act) throws InterruptedException;

    /** Waits until queued keys have left and messages are acknowledged, but no longer than that. */
    void settle(long boundNanos) throws InterruptedException;
}
