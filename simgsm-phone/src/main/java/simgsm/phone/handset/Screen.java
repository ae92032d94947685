package simgsm.phone.handset;

/** What the display shows. */
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

    /** Who is to get the text. */
    record Recipient(String number) implements Screen {}

    /** A message just handed in, and how far it has got since; any key leads on. */
    record Sent(StoredMessage message) implements Screen {}

    /** A short word from the phone; any key leads on. @param detail what it is about, a number or nothing */
    record Note(Kind kind, String detail) implements Screen {
        /** What is told. */
        public enum Kind {
            REFUSED,
            NOT_A_NUMBER,
            /** The network refused keys; the detail is the cause. */
            KEYS_REFUSED
        }
    }
}
