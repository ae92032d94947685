package simgsm.center.smsc;

/**
 * Outcome of an attempt to deliver a message. A failed attempt at a mobile concerns the mobile: its queue pauses. At an
 * application it concerns the message or one session: the other messages continue.
 */
public enum DeliveryOutcome {
    DELIVERED,
    /** RP cause 22; RP-SMMA reports free memory of the receiver. */
    MEMORY_FULL,
    /** Permanently refused by the receiver. */
    REFUSED,
    /** No answer to paging, or no connection: retried at the next registration, or by the schedule. */
    ABSENT,
    /** The transfer was interrupted: retried by the schedule. */
    FAILED,
    /** An application throttles: this message is retried after seconds. */
    BUSY,
    /** An application refuses the message temporarily: this message is retried by the schedule. */
    POSTPONED,
    /** An application has not answered in time: this message is retried by the schedule. */
    UNANSWERED,
    /** The application's session ended before the answer: retried once another session serves. */
    WITHDRAWN
}
