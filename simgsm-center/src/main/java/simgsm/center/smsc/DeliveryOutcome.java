package simgsm.center.smsc;

/**
 * How an attempt to deliver a message ended. A failed attempt at a mobile says something of the mobile: its queue pauses. At
 * an application it says something of the message or of one session: the other messages go on.
 */
public enum DeliveryOutcome {
    DELIVERED,
    /** RP cause 22; RP-SMMA reports that the receiver has memory again. */
    MEMORY_FULL,
    /** Permanently refused by the receiver. */
    REFUSED,
    /** No answer to paging, or no connection: tried again at the next registration, or by the schedule. */
    ABSENT,
    /** The transfer broke off: tried again by the schedule. */
    FAILED,
    /** An application throttles: this message is tried again after seconds. */
    BUSY,
    /** An application refuses the message for now: this message is tried again by the schedule. */
    POSTPONED,
    /** An application has not answered in time: this message is tried again by the schedule. */
    UNANSWERED,
    /** The application's session ended before the answer: tried again as soon as another session serves. */
    WITHDRAWN
}
