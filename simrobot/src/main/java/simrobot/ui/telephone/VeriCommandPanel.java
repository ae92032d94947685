package simrobot.ui.telephone;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Locale;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.Keycaps;
import simgsm.ui.Lamp;
import simgsm.ui.Theme;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.TextLine;
import vericommand.OrderCourse;
import vericommand.VeriCommandSnapshot;

/** VeriCommand's state: the keys received, the order in words, the verdict, the replies. */
public final class VeriCommandPanel extends JPanel {
    private final Card card;
    private boolean isCompact;
    private boolean areKeysHidden;

    private final TextBundle texts;
    private final TextLine from = new TextLine("order.from", Theme::base, Ink.QUIET);
    private final Keycaps keys;
    private final TextLine words = new TextLine("order.words", Theme::strong, Ink.TEXT);
    private final Lamp verdict;
    private final Lamp course;
    private final Locale language;
    private final ReplyLabels replies;
    private final TextLine reply = new TextLine("order.reply", Theme::small, Ink.QUIET).overTwoRows();

    public VeriCommandPanel(TextBundle texts, Locale language) {
        super(new BorderLayout());
        this.texts = texts;
        this.language = language;
        setOpaque(false);
        keys = new Keycaps(texts.of("order.keys"));
        keys.setName("order.keys");
        verdict = new Lamp(texts.of("order.verdict"));
        verdict.setName("order.verdict");
        course = new Lamp(texts.of("order.course"));
        course.setName("order.course");
        replies = new ReplyLabels(language);
        JPanel content = Arrange.column(
                6,
                from,
                keys,
                words,
                Arrange.row(Theme.GRID, Arrange.growing(verdict), course),
                Arrange.spring(),
                replies,
                reply);
        card = new Card(texts.of("order.title"), content);
        add(card, BorderLayout.CENTER);
    }

    /**
     * Chooses the form.
     *
     * @param compact without title, origin and the reply's text, which the labels' tool tips have; the words of an
     *     accepted order take the verdict's place
     */
    public void setCompact(boolean compact) {
        isCompact = compact;
        words.setVisible(!compact);
        card.setTitleVisible(!compact);
        from.setVisible(!compact);
        reply.setVisible(!compact);
    }

    public void show(TelephoneSnapshot line) {
        VeriCommandSnapshot order = line.orders();
        from.show(origin(order));
        if (areKeysHidden) {
            keys.show("?".repeat(order.keys().length()), 0);
            words.show("");
            verdict.show(StatusMark.HALF_DISC, Ink.QUIET, texts.of("order.hidden"));
            course.setVisible(false);
        } else {
            keys.show(order.keys(), order.failingPosition());
            words.show(order.words().in(language));
            showVerdict(order);
            showCourse(order.course());
        }
        replies.show(order.message() ? order.replies() : tones(line.tones()));
        reply.show(newest(order.replies()));
    }

    /** Hides the keys of the order while a student reads them off the tone scope. */
    public void setKeysHidden(boolean hidden) {
        areKeysHidden = hidden;
    }

    private String origin(VeriCommandSnapshot order) {
        if (order.from().isEmpty() && !order.inCall() && order.keys().isEmpty()) {
            return texts.of("order.from.nobody");
        }
        String number = order.from().isEmpty() ? texts.of("order.from.unknown") : order.from();
        String kind = order.message() ? "order.from.sms" : order.inCall() ? "order.from.call" : "order.from.ended";
        return texts.of(kind, number);
    }

    private void showVerdict(VeriCommandSnapshot order) {
        String told = order.verdictText().in(language);
        switch (order.verdictWord()) {
            case "accepted" -> {
                String said = order.words().in(language);
                said = isCompact && !said.isEmpty() ? said : told;
                verdict.show(StatusMark.TICK, Ink.TEXT, said);
            }
            case VeriCommandSnapshot.UNFINISHED, VeriCommandSnapshot.IDLE -> verdict.show(StatusMark.SQUARE, Ink.WARNING, told);
            case "refused" -> verdict.show(StatusMark.CROSS, Ink.WARNING, told);
            case "invalid" -> verdict.show(StatusMark.CROSS, Ink.DANGER, told);
            default -> {
                String waiting = order.keys().isEmpty() ? "order.waiting" : "order.reading";
                verdict.show(
                        order.keys().isEmpty() ? StatusMark.RING : StatusMark.HALF_DISC, Ink.QUIET, texts.of(waiting));
            }
        }
    }

    /** Beside the verdict, which tells only whether the order was accepted: what has become of it. */
    private void showCourse(OrderCourse now) {
        course.setVisible(now != OrderCourse.NONE);
        String said = now.words(language);
        switch (now) {
            case NONE -> {}
            case UNDER_WAY -> course.show(StatusMark.ARROW, Ink.ACCENT, said);
            case EXECUTED -> course.show(StatusMark.DISC, Ink.GOOD, said);
            case COLLISION -> course.show(StatusMark.BURST, Ink.DANGER, said);
            case INFINITE_LOOP -> course.show(StatusMark.RING, Ink.DANGER, said);
            case NOT_POSSIBLE -> course.show(StatusMark.CROSS, Ink.WARNING, said);
            case STOPPED, BROKEN_OFF -> course.show(StatusMark.SQUARE, Ink.WARNING, said);
            case CALL_ENDED -> course.show(StatusMark.SLASHED_RING, Ink.WARNING, said);
        }
    }

    /** In a call each reply tone is one label. */
    private static List<String> tones(String digits) {
        return digits.chars().mapToObj(digit -> String.valueOf((char) digit)).toList();
    }

    private static String newest(List<String> replies) {
        return replies.isEmpty() ? "" : replies.get(replies.size() - 1);
    }
}
