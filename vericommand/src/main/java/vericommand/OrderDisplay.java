package vericommand;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.Function;

/** Collects a window's data on orders: at most the last 320 keys and the last 8 replies. */
final class OrderDisplay {
    private static final int MAX_KEYS = 320;
    private static final int MAX_REPLIES = 8;

    private final ReplyTexts texts;
    private final Deque<String> replies = new ArrayDeque<>();
    private String from = "";
    private String keys = "";
    private OrderSource source = OrderSource.CALL;
    private LocalizedText words = LocalizedText.EMPTY;
    private String verdictWord = "";
    private LocalizedText verdictText = LocalizedText.EMPTY;
    private int failingPosition;
    private OrderCourse course = OrderCourse.NONE;
    /** The accepted order shown; null if none. */
    private Order accepted;

    OrderDisplay(ReplyTexts texts) {
        this.texts = texts;
    }

    void begin(String from, OrderSource source) {
        this.from = from;
        this.source = source;
        replies.clear();
        keys("");
    }

    void keys(String all) {
        keys = all;
        words = LocalizedText.EMPTY;
        verdictWord = "";
        verdictText = LocalizedText.EMPTY;
        failingPosition = 0;
        course = OrderCourse.NONE;
        accepted = null;
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

    OrderSource source() {
        return source;
    }

    void verdict(Verdict verdict) {
        keys(verdict.keys());
        verdictWord = verdict.word();
        if (verdict instanceof Verdict.Invalid invalid) {
            failingPosition = invalid.fault().position();
            verdictText = said(in -> in.invalid(invalid.fault()).text());
        } else if (verdict instanceof Verdict.NoProcess none) {
            failingPosition = none.position();
            words = LocalizedText.of(none.order()::words);
            verdictText = said(in -> in.noProcess(none).text());
        } else if (verdict instanceof Verdict.Refused refused) {
            words = LocalizedText.of(refused.order()::words);
            verdictText =
                    said(in -> in.refused(refused.tone(), refused.status()).text());
        } else {
            accepted = ((Verdict.Accepted) verdict).order();
            course = OrderCourse.UNDER_WAY;
            words = LocalizedText.of(accepted::words);
            verdictText = said(in -> in.text("verdict.accepted"));
        }
    }

    /** Sets the course of an order if it is still shown. */
    void course(Order order, OrderCourse now) {
        boolean isBraked = now == OrderCourse.STOPPED || now == OrderCourse.BROKEN_OFF;
        if (order == accepted && !(isBraked && course == OrderCourse.CALL_ENDED)) {
            course = now;
        }
    }

    /**
     * The call that gave the order under way has ended. @param stops true if the robot brakes, false if it finishes
     * the order
     */
    void callEnded(Order order, boolean stops) {
        if (stops) {
            course(order, OrderCourse.CALL_ENDED);
        } else if (order == accepted) {
            verdictText = said(in -> in.text("verdict.finishing"));
        }
    }

    /** The call has ended before its order was complete. */
    void callEndedWithinOrder() {
        verdictWord = VeriCommandSnapshot.UNFINISHED;
        verdictText = said(in -> in.text("verdict.unfinished"));
    }

    /** The call has ended for want of keys; the reason replaces the words of its last order. */
    void callIdle(int seconds) {
        keys(keys);
        verdictWord = VeriCommandSnapshot.IDLE;
        verdictText = said(in -> in.text("verdict.idle", "" + seconds));
    }

    private LocalizedText said(Function<ReplyTexts, String> text) {
        return LocalizedText.of(language -> text.apply(texts.in(language)));
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
                source,
                inCall,
                underWay,
                keys,
                words,
                verdictWord,
                verdictText,
                course,
                failingPosition,
                List.copyOf(replies));
    }
}
