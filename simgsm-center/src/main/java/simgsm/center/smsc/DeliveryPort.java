package simgsm.center.smsc;

import java.util.function.Consumer;
import simgsm.air.Msisdn;

/** Delivers messages to mobiles and applications. */
public interface DeliveryPort {
    /** The number of the subscriber or application that was dialled so. */
    default Msisdn called(Msisdn dialled) {
        return dialled.plain();
    }

    /** True if messages to this number are accepted: it is assigned, or may be assigned later. */
    default boolean isServed(Msisdn number) {
        return true;
    }

    /** True if the number is a subscriber's, attached or not. */
    default boolean isSubscriber(Msisdn number) {
        return false;
    }

    /**
     * True if an attempt can be made now. After {@code false}, {@link ShortMessageCenter#available} or {@link
     * ShortMessageCenter#roomFor} is called at a change.
     */
    boolean isReachable(Destination destination);

    /** Maximum of simultaneous attempts to one destination. */
    default int window(Destination destination) {
        return 1;
    }

    /**
     * Begins one attempt.
     *
     * @param moreWaiting true if further messages wait for the destination (TP-MMS)
     * @param ended receives the outcome, once
     */
    void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended);

    /** The destination's queue is empty. */
    default void emptied(Destination destination) {}
}
