package simgsm.phone.screen;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.store.StoredMessage;

/** The contents of the display. */
public sealed interface Screen {
    /** The number being typed, or the call. */
    record HomeView() implements Screen {}

    /** A sign before a row of a list. */
    enum Mark {
        NONE,
        CHOSEN,
        NOT_CHOSEN,
        NAME,
        DIALLED,
        RECEIVED,
        MISSED,
        UNREAD,
        READ,
        DRAFT,
        SENDING,
        SENT,
        DELIVERED,
        FAILED;

        /** The mark of a message by its delivery; of a received one by having been read. */
        public static Mark of(StoredMessage message) {
            return switch (message.delivery()) {
                case RECEIVED -> message.read() ? READ : UNREAD;
                case DRAFT -> DRAFT;
                case SENDING -> SENDING;
                case SENT -> SENT;
                case DELIVERED -> DELIVERED;
                case FAILED -> FAILED;
            };
        }
    }

    /**
     * A row of a list.
     *
     * @param note at the right edge
     * @param at shown instead of the note
     * @param detail on its own line, empty for rows of one line
     */
    record Row(Mark mark, Words label, Words note, Optional<Instant> at, String detail) {
        static Row of(Words label) {
            return of(label, Words.NONE);
        }

        static Row of(Words label, Words note) {
            return new Row(Mark.NONE, label, note, Optional.empty(), "");
        }

        static Row of(Mark mark, Words label) {
            return new Row(mark, label, Words.NONE, Optional.empty(), "");
        }
    }

    /**
     * A menu or a list, with one selected row.
     *
     * @param numbered true if the digit keys choose rows
     */
    record Listing(Words title, List<Row> rows, int selected, boolean numbered) implements Screen {}

    /** A message being read. @param scroll lines scrolled down */
    record MessageView(MessageFolder folder, StoredMessage message, int scroll) implements Screen {}

    /** Lines of text. */
    record Details(Words title, List<Words> lines) implements Screen {}

    /**
     * A message being written.
     *
     * @param caret characters before the cursor
     * @param pending true if the last letter may still change
     * @param choices the letters of its key
     */
    record Writing(String text, int caret, boolean pending, String choices, TextEntry.Mode mode) implements Screen {}

    /**
     * A line being keyed in, such as a number or a name.
     *
     * @param caret characters before the cursor
     * @param choices the letters of the pending one's key; empty if none is pending
     * @param mode empty for digits only
     */
    record Entry(Words title, String text, int caret, String choices, Optional<TextEntry.Mode> mode)
            implements Screen {}

    /** A message just submitted and its progress; any key leaves. */
    record Sent(StoredMessage message) implements Screen {}

    /**
     * A USSD dialogue.
     *
     * @param text of the network; until it arrives, the user's
     * @param reply as typed so far
     */
    record Ussd(Phase phase, String text, String reply) implements Screen {
        public enum Phase {
            /** The network's answer is awaited. */
            WAITING,
            /** The network awaits a reply. */
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
            /** Without its PIN or PUK the SIM permits emergency calls only. */
            SIM_LOCKED,
            SAVED,
            /** The SIM refuses a PIN or PUK; the detail is the number of tries left. */
            PIN_WRONG,
            /** The third wrong PIN: the SIM demands the PUK. */
            PIN_BLOCKED,
            /** A PIN has 4 to 8 digits, a PUK 8. */
            PIN_LENGTH,
            /** The two new PINs differ. */
            PIN_DIFFERS,
            /** The SIM has no room for another name. */
            SIM_FULL,
            /** The network refused keys; the detail is the cause. */
            KEYS_REFUSED,
            /** The network does not know the code. */
            USSD_UNKNOWN,
            /** The network refused; the detail is the error's code, empty if it gave none. */
            USSD_REFUSED,
            USSD_NO_SERVICE,
            USSD_NO_ANSWER
        }
    }
}
