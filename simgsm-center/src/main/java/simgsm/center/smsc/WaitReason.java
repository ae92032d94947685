package simgsm.center.smsc;

/** The event for which a message waits. */
public enum WaitReason {
    /** An attempt is active. */
    UNDER_WAY,
    /** Another message to the same receiver is first. */
    BEHIND_OTHERS,
    /** The receiver is absent; tried when it registers. */
    AWAITING_RECEIVER,
    /** The receiver's memory is full (RP cause 22); tried after RP-SMMA, or by the schedule. */
    AWAITING_MEMORY,
    /** The last attempt failed; tried by the schedule, or when the receiver registers. */
    AWAITING_RETRY,
    /** Its time of delivery is in the future. */
    SCHEDULED,
    /** The message has ended and waits for nothing. */
    ENDED
}
