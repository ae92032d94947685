package simgsm.phone.handset;

/** The phone's folders for messages. */
public enum MessageFolder {
    INBOX,
    OUTBOX,
    BROADCASTS
}
