package simgsm.center.smsc;

/** How an attempt to deliver a message ended. */
public enum DeliveryOutcome {
    DELIVERED,
    /** RP cause 22; RP-SMMA reports that the receiver has memory again. */
    MEMORY_FULL,
    /** The receiver is throttling: tried again after seconds. */
    BUSY,
    /** Permanently refused by the receiver. */
    REFUSED,
    /** No answer to paging, or no connection: tried again at the next registration, or by the schedule. */
    ABSENT,
    /** The transfer broke off: tried again by the schedule. */
    FAILED
}
