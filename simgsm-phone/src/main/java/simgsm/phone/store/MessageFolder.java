package simgsm.phone.store;

/** The phone's folders of messages. */
public enum MessageFolder {
    INBOX,
    OUTBOX,
    /** Texts that are not sent yet. */
    DRAFTS,
    BROADCASTS
}
