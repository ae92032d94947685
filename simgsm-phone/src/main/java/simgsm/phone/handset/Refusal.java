package simgsm.phone.handset;

/** The reasons for which the handset refuses a command. */
public enum Refusal {
    CALL_UNDER_WAY("a call is under way; hang up first"),
    SIM_LOCKED("the SIM is locked; only emergency numbers, such as 112, can be called"),
    SIM_REFUSES("the SIM does not take this code now, or the two new PINs differ"),
    NO_CALL("there is no call; dial or answer first"),
    NOTHING_RINGS("no call rings"),
    NOT_ANSWERED("the call is not answered; answer first"),
    SWITCHED_OFF("the phone is switched off; power on first"),
    NOTHING_TO_HOLD("there is no active call and no held one, or the network has still to answer"),
    NO_SECOND_CALL("no call waits or is held"),
    EMPTY_TEXT("the message has no text"),
    TEXT_TOO_LONG("the text needs more than 255 messages"),
    USSD_UNDER_WAY("a USSD dialogue is under way, and the network does not wait for a reply"),
    USSD_TOO_LONG("the text has more than 182 characters, or 80 outside the GSM alphabet");

    private final String words;

    Refusal(String words) {
        this.words = words;
    }

    /** In English, for console and log. */
    public String words() {
        return words;
    }
}
