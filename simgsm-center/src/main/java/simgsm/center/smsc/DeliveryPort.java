package simgsm.center.smsc;

import java.util.function.Consumer;
import simgsm.air.Msisdn;

/** Delivers messages to mobiles and applications. */
public interface DeliveryPort {
    /** Whether messages to this number are accepted: it is assigned, or may be assigned later. */
    default boolean isServed(Msisdn number) {
        return true;
    }

    /** Whether the number is a subscriber's, attached or not. */
    default boolean isSubscriber(Msisdn number) {
        return false;
    }

    /**
     * Whether an attempt can be made now. After {@code false}, {@link ShortMessageCenter#available} or {@link
     * ShortMessageCenter#roomFor} is called when that changes.
     */
    boolean isReachable(Destination destination);

    /** How many attempts to one destination may be under way at a time. */
    default int window(Destination destination) {
        return 1;
    }

    /**
     * Begins one attempt.
     *
     * @param moreWaiting whether further messages wait for the destination (TP-MMS)
     * @param ended is given the outcome, once
     */
    void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended);

    /** No message waits for this destination any more. */
    default void emptied(Destination destination) {}
}
