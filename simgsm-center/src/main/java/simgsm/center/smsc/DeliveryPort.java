package simgsm.center.smsc;

import simgsm.air.Msisdn;

/** The way from the short message centre to receivers. */
public interface DeliveryPort {
    /** Whether what is sent to this number can ever arrive; nothing else is taken. */
    default boolean isServed(Msisdn number) {
        return true;
    }

    /** Whether an attempt makes sense now. Who says no tells the centre when that changes. */
    boolean isReachable(Recipient receiver);

    /** How many attempts to one receiver may be under way at a time. */
    default int window(Recipient receiver) {
        return 1;
    }

    /**
     * Begins one attempt.
     *
     * @param moreWaiting whether the receiver may be told that more is to come
     */
    void deliver(Envelope envelope, boolean moreWaiting, DeliveryReceipt receipt);
}
