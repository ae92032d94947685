package simgsm.phone.handset;

/** The items of the phone's menu, in their order. */
public enum MenuItem {
    INBOX,
    WRITE,
    OUTBOX,
    BROADCASTS,
    SWITCH_OFF
}
