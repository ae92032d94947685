package simgsm.center.smsc;

/** What has become of a short message. */
public enum MessageState {
    /** Stored, on its way. */
    ACCEPTED,
    DELIVERED,
    /** Its validity ended before it could be delivered. */
    EXPIRED,
    /** Refused by the receiver, or by the store. */
    REJECTED,
    /** Called back by the application that sent it. */
    DELETED
}
