package simgsm.center.smsc;

/** What a message waits for. */
public enum Standing {
    /** An attempt is under way. */
    UNDER_WAY,
    /** Another message to the same receiver goes first. */
    BEHIND_OTHERS,
    /** The receiver is not there; its coming is the next occasion. */
    AWAITING_RECEIVER,
    /** The receiver has no room (RP cause 22); its word that it has (RP-SMMA) is the next occasion, or the schedule. */
    AWAITING_MEMORY,
    /** The last attempt failed; the schedule says when the next one begins, unless the receiver appears before. */
    AWAITING_RETRY,
    /** Nothing any more. */
    ENDED
}
