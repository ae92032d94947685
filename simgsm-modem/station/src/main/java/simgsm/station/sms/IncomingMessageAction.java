package simgsm.station.sms;

/** What {@link MessageReceiver} does on a transition. */
public enum IncomingMessageAction {
    SEND_CP_ACK,
    /** Takes or refuses the message and prepares the answer. */
    TAKE_MESSAGE,
    SEND_ANSWER,
    START_TC1,
    STOP_TC1,
    /** The network may not have the answer: it may deliver the message again. */
    EXPECT_DUPLICATE
}
