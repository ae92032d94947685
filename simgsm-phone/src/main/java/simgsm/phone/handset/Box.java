package simgsm.phone.handset;

/** Where messages lie. */
public enum Box {
    INBOX,
    OUTBOX,
    BROADCASTS
}
