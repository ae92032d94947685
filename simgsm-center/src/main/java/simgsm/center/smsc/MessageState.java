package simgsm.center.smsc;

/** State of a short message. */
public enum MessageState {
    /** Stored, not yet delivered. */
    ACCEPTED,
    DELIVERED,
    /** Its validity ended before it was delivered. */
    EXPIRED,
    /** Refused by the receiver, or by the store. */
    REJECTED,
    /** Cancelled by the application that sent it. */
    DELETED
}
