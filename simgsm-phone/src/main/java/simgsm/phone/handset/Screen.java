package simgsm.phone.handset;

/** The contents of the display. */
public sealed interface Screen {
    /** The number being typed, or the call. */
    record Home() implements Screen {}

    /** @param selected index of the chosen {@link MenuItem} */
    record Menu(int selected) implements Screen {}

    /** @param selected index from the newest */
    record MessageList(MessageFolder box, int selected) implements Screen {}

    /** @param selected index from the newest @param scroll lines scrolled down */
    record MessageView(MessageFolder box, int selected, int scroll) implements Screen {}

    /**
     * A text being written.
     *
     * @param pending whether the last letter may still change
     * @param choices the letters among which it is chosen
     */
    record Writing(String text, boolean pending, String choices, TextEntry.Mode mode) implements Screen {}

    /** Entry of the number to which the text goes. */
    record Recipient(String number) implements Screen {}

    /** A message just submitted and its progress; any key leaves. */
    record Sent(StoredMessage message) implements Screen {}

    /**
     * A USSD dialogue.
     *
     * @param text of the network; while it is awaited, what the user has sent
     * @param reply as typed so far
     */
    record Ussd(Phase phase, String text, String reply) implements Screen {
        public enum Phase {
            /** The network works. */
            WAITING,
            /** The network waits for a reply. */
            ASKED,
            /** The dialogue is over; any key leaves. */
            ANSWERED
        }
    }

    /** A short notice; any key leaves. @param detail a number or a cause, or empty */
    record Note(Kind kind, String detail) implements Screen {
        public enum Kind {
            REFUSED,
            NOT_A_NUMBER,
            /** The network refused keys; the detail is the cause. */
            KEYS_REFUSED,
            /** The network does not know the code. */
            USSD_UNKNOWN,
            /** The network refused; the detail is the error's name in the standard. */
            USSD_REFUSED,
            USSD_NO_SERVICE,
            USSD_NO_ANSWER
        }
    }
}
