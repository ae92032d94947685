package vericommand;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;

/** Collects what a window shows of the orders: the last 320 keys at most, and the last 8 replies. */
final class OrderDisplay {
    private static final int MAX_KEYS = 320;
    private static final int MAX_REPLIES = 8;

    private final Locale locale;
    private final ReplyTexts texts;
    private final Deque<String> replies = new ArrayDeque<>();
    private String from = "";
    private String keys = "";
    private boolean message;
    private String words = "";
    private String verdictWord = "";
    private String verdictText = "";
    private int failingPosition;

    OrderDisplay(Locale locale, ReplyTexts texts) {
        this.locale = locale;
        this.texts = texts;
    }

    void begin(String from, boolean message) {
        this.from = from;
        this.message = message;
        replies.clear();
        keys("");
    }

    void keys(String all) {
        keys = all;
        words = "";
        verdictWord = "";
        verdictText = "";
        failingPosition = 0;
    }

    /**
     * Adds a key. A new order replaces the shown one; but the closing of a broken order opens an empty one, so a fault
     * stays in view until the open order has a key other than {@code *}.
     *
     * @param open the keys of the open order, empty if none is open
     */
    void key(char key, String open) {
        boolean faultStays = failingPosition > 0 && open.chars().allMatch(c -> c == '*');
        if (!open.isEmpty() && !faultStays) {
            keys(open);
        } else if (keys.length() < MAX_KEYS) {
            keys += key;
        }
    }

    boolean showsMessage() {
        return message;
    }

    void verdict(Verdict verdict) {
        keys(verdict.keys());
        verdictWord = verdict.word();
        if (verdict instanceof Verdict.Invalid invalid) {
            failingPosition = invalid.fault().position();
            verdictText = texts.invalid(invalid.fault()).text();
        } else if (verdict instanceof Verdict.NoProcess none) {
            failingPosition = none.position();
            words = none.order().words(locale);
            verdictText = texts.noProcess(none).text();
        } else if (verdict instanceof Verdict.Refused refused) {
            words = refused.order().words(locale);
            verdictText = texts.refused(refused.tone(), refused.status()).text();
        } else {
            words = ((Verdict.Accepted) verdict).order().words(locale);
            verdictText = texts.text("verdict.accepted");
        }
    }

    /** The call that gave the order under way has ended. @param stops whether the robot brakes, or finishes the order */
    void callEnded(boolean stops) {
        verdictWord = stops ? VeriCommandSnapshot.STOPPED : verdictWord;
        verdictText = texts.text(stops ? "verdict.stopped" : "verdict.finishing");
    }

    /** The call has ended before its order was whole. */
    void callEndedWithinOrder() {
        verdictWord = VeriCommandSnapshot.STOPPED;
        verdictText = texts.text("verdict.unfinished");
    }

    void reply(Reply reply) {
        if (replies.size() == MAX_REPLIES) {
            replies.removeFirst();
        }
        replies.addLast(reply.message());
    }

    VeriCommandSnapshot snapshot(boolean inCall, boolean underWay) {
        return new VeriCommandSnapshot(
                from,
                message,
                inCall,
                underWay,
                keys,
                words,
                verdictWord,
                verdictText,
                failingPosition,
                List.copyOf(replies));
    }
}
