package simgsm.phone.handset;

/** Where messages lie. */
public enum MessageFolder {
    INBOX,
    OUTBOX,
    BROADCASTS
}
