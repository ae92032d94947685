package simgsm.center.msc.ss;

/**
 * The outcome of a question that the network asked a mobile.
 *
 * @param text of the reply; else empty
 */
public record UssdOutcome(Kind kind, String text) {
    /** The kinds of outcome. */
    public enum Kind {
        REPLIED,
        /** The mobile is not attached, does not answer paging, or was lost. */
        ABSENT,
        /** It has another dialogue. */
        BUSY,
        /** The user has ended the dialogue, or the mobile does not know the operation. */
        REFUSED,
        /** No reply in time. */
        NO_REPLY
    }

    static UssdOutcome of(Kind kind) {
        return new UssdOutcome(kind, "");
    }
}
