package simgsm.center.smsc;

/** How an attempt to give a message to its receiver ended. */
public enum DeliveryOutcome {
    DELIVERED,
    /** RP cause 22: the receiver will say when it has room. */
    MEMORY_FULL,
    /** The receiver takes messages, only not so many at once; it is asked again in a moment. */
    BUSY,
    /** The receiver does not want it, for good. */
    REFUSED,
    /** Nobody answered; its next registration is the time to try again, or the schedule. */
    ABSENT,
    /** The dialogue broke off; the schedule says when to try again. */
    FAILED
}
