package simgsm.station.context;

/** The endings of a USSD dialogue without a last text. */
public enum UssdEnding {
    /** The network has accepted the reply, or the user has read its text. */
    COMPLETED("completed"),
    /** The network has refused the request. */
    REFUSED("refused by the network"),
    /** The network has ended the dialogue without an answer. */
    ENDED_BY_NETWORK("ended by the network"),
    /** The network has not answered in time. */
    NO_ANSWER("no answer from the network"),
    /** There is no service, or it was lost. */
    NO_SERVICE("no service"),
    /** The user has ended the dialogue. */
    CANCELLED("cancelled");

    private final String title;

    UssdEnding(String title) {
        this.title = title;
    }

    /** In words, for a console. */
    public String title() {
        return title;
    }
}
