package vericommand;

/** Receives the output of a {@link VeriCommand}, on its owner thread. */
public interface VeriCommandListener {
    /** Send this tone to the caller. */
    void tone(ReplyTone tone);

    /** Send this outcome's tone to the caller; its text may follow in words. */
    default void answer(Reply reply) {
        tone(reply.tone());
    }

    /** The caller asks by {@code *#} to be heard. @return false if no orders by voice are taken; the keys are stray then */
    default boolean listen() {
        return false;
    }

    /** Clear the call once the tones sent so far have left: the robot is off. */
    void clearCall();

    /** Send this short message. */
    void message(String to, String text);

    /** True: an order is being executed from now on; false: none is. */
    default void underWay(boolean underWay) {}

    /** An order has been read and verified; nothing has moved yet. @param keys as received, without blanks */
    default void order(String keys, Verdict verdict) {}

    /** One instruction has ended in any way. */
    default void instructionEnded(Instruction instruction) {}

    /** An order has ended or was refused. An order of a call that has ended has no outcome. */
    default void outcome(Reply reply) {}

    /** A short message came from a number that may not command; it gets no reply. */
    default void senderIgnored(String from) {}

    /** A short message is a reply of this suite; it gets no reply. */
    default void replyIgnored(String from) {}

    /** A sender has sent too many messages without a valid order; further ones get no reply for a minute. */
    default void senderSilenced(String from) {}

    /** {@link VeriCommand#snapshot()} has changed. */
    default void changed() {}
}
