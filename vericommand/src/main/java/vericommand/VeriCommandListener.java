package vericommand;

/** What a {@link VeriCommand} has sent and told, on its owner thread. */
public interface VeriCommandListener {
    /** Send this tone to the caller. */
    void tone(ReplyTone tone);

    /** Clear the call as soon as the tones ordered so far have left: the robot is off. */
    void clearCall();

    /** Send this short message. */
    void message(String to, String text);

    /** An order is under way from here on, or none any more. */
    default void underWay(boolean underWay) {}

    /** An order has been read and verified; nothing has moved yet. @param keys as they came, without blanks */
    default void order(String keys, Verdict verdict) {}

    /** One instruction is over, however it ended. */
    default void instructionEnded(Instruction instruction) {}

    /** An order is over, or was never begun. An order whose caller has gone has no outcome. */
    default void outcome(Reply reply) {}

    /** A short message came from somebody who may not command; it gets no reply. */
    default void senderIgnored(String from) {}

    /** There is a new {@link VeriCommand#snapshot()}. */
    default void changed() {}
}
