package simrobot.ui.telephone;

import java.awt.BorderLayout;
import java.awt.Container;
import java.awt.Dimension;
import java.util.List;
import java.util.Locale;
import javax.swing.JComponent;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.ui.Arrange.FixedLayout;
import simgsm.ui.Card;
import simgsm.ui.Keycaps;
import simgsm.ui.Lamp;
import simgsm.ui.Theme;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.TextLine;
import vericommand.OrderCourse;
import vericommand.OrderSource;
import vericommand.VeriCommandSnapshot;

/** VeriCommand's state: the keys received, the order in words, the verdict, the replies. */
public final class VeriCommandPanel extends JPanel {
    private final Card card;
    private boolean isCompact;
    private boolean areKeysHidden;
    private OrderCourse courseNow = OrderCourse.NONE;

    private final TextBundle texts;
    private final TextLine from = new TextLine("order.from", Theme::base, Ink.QUIET);
    private final Keycaps keys;
    private final TextLine words = new TextLine("order.words", Theme::strong, Ink.TEXT).overTwoRows();
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
        verdict = new Lamp(texts.of("order.verdict")).wrapping();
        verdict.setName("order.verdict");
        course = new Lamp(texts.of("order.course"));
        course.setName("order.course");
        replies = new ReplyLabels(language);
        JPanel content = new JPanel(new Parts());
        content.setOpaque(false);
        for (JComponent part : new JComponent[] {from, keys, words, verdict, course, replies, reply}) {
            content.add(part);
        }
        card = new Card(texts.of("order.title"), content);
        add(card, BorderLayout.CENTER);
    }

    /**
     * Selects the form.
     *
     * @param compact without title, origin and the reply's text, which the labels' tool tips have; the words of an
     * accepted order replace the verdict
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
        replies.show(order.source() == OrderSource.CALL ? tones(line.tones()) : order.replies());
        reply.show(line.words().isEmpty() ? newest(order.replies()) : texts.of("log.said", line.words()));
    }

    /** Hides the order's keys while a student reads them from the tone scope. */
    public void setKeysHidden(boolean hidden) {
        areKeysHidden = hidden;
    }

    private String origin(VeriCommandSnapshot order) {
        if (order.from().isEmpty() && !order.inCall() && order.keys().isEmpty()) {
            return texts.of("order.from.nobody");
        }
        String number = order.from().isEmpty() ? texts.of("order.from.unknown") : order.from();
        String kind = switch (order.source()) {
            case CALL -> order.inCall() ? "order.from.call" : "order.from.ended";
            case MESSAGE -> "order.from.sms";
            case PROGRAM -> "order.from.program";
        };
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
            case VeriCommandSnapshot.UNFINISHED, VeriCommandSnapshot.IDLE ->
                verdict.show(StatusMark.SQUARE, Ink.WARNING, told);
            case "refused" -> verdict.show(StatusMark.CROSS, Ink.WARNING, told);
            case "invalid" -> verdict.show(StatusMark.CROSS, Ink.DANGER, told);
            default -> {
                boolean isReading = order.inCall() && !order.keys().isEmpty();
                verdict.show(
                        isReading ? StatusMark.HALF_DISC : StatusMark.RING,
                        Ink.QUIET,
                        texts.of(isReading ? "order.reading" : "order.waiting"));
            }
        }
    }

    /** Shows the order's outcome next to the verdict, which is only its acceptance. */
    private void showCourse(OrderCourse now) {
        courseNow = now;
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

    /**
     * Lays out all parts in one column, the replies at its bottom; the outcome next to the verdict if both fit, else
     * below it. If the height is short the keys shrink, then outcome or replies are hidden, because they mostly say the
     * same.
     */
    private final class Parts implements FixedLayout {
        private static final int GAP_UNITS = 6;
        /** Number of rows reserved for the verdict. */
        private static final int ROWS = 2;
        /** Minimum height of the keys in one row. */
        private static final int LEAST_KEYS_UNITS = 21;

        /** Keys, a verdict in one row, and the replies. */
        @Override
        public Dimension minimumLayoutSize(Container parent) {
            int height = keys.getMinimumSize().height + course.getPreferredSize().height + gap();
            return new Dimension(Theme.px(120), height + others());
        }

        /** Independent of the order's length, so that the tone scope keeps its size. */
        @Override
        public Dimension preferredLayoutSize(Container parent) {
            int keysHeight = (isCompact ? keys.getMinimumSize() : keys.getPreferredSize()).height;
            int height = keysHeight + (ROWS + 1) * course.getPreferredSize().height + 2 * gap();
            return new Dimension(Theme.px(120), height + others());
        }

        private int others() {
            int height = 0;
            for (JComponent part : new JComponent[] {from, words, replies, reply}) {
                height += part.isVisible() ? part.getPreferredSize().height + gap() : 0;
            }
            return height;
        }

        @Override
        public void layoutContainer(Container parent) {
            int width = parent.getWidth();
            // The number of rows depends on the width, which a previous layout has set.
            keys.setSize(width, keys.getHeight());
            int courseWidth = course.getPreferredSize().width;
            int courseHeight = course.getPreferredSize().height;
            int besideWidth = verdict.getPreferredSize().width + Theme.px(Theme.GRID) + courseWidth;
            boolean isBeside = course.isVisible() && besideWidth <= width;
            boolean isBelow = course.isVisible() && !isBeside;
            int verdictHeight = isBeside ? courseHeight : verdict.heightFor(width);
            int wordsHeight = words.heightFor(width);
            int repliesHeight = replies.getPreferredSize().height;

            int bottom = above(parent.getHeight(), width, reply, reply.getPreferredSize().height);
            int top = below(0, width, from, from.getPreferredSize().height);
            int rest = bottom - top - verdictHeight - gap() - repliesHeight - gap();
            rest -= words.isVisible() ? wordsHeight + gap() : 0;
            if (isBelow && rest - courseHeight - gap() < Theme.px(LEAST_KEYS_UNITS)) {
                isBelow = !isSaidByReplies();
                repliesHeight = isBelow ? 0 : repliesHeight;
                rest += isBelow ? replies.getPreferredSize().height + gap() : 0;
            }
            rest -= isBelow ? courseHeight + gap() : 0;
            bottom = above(bottom, width, replies, repliesHeight);
            int keysHeight = Math.min(keys.getPreferredSize().height, Math.max(Theme.px(LEAST_KEYS_UNITS), rest));
            top = below(top, width, keys, keysHeight);
            top = below(top, width, words, wordsHeight);
            int room = bottom - top - (isBelow ? courseHeight + gap() : 0);
            verdictHeight = Math.max(courseHeight, Math.min(verdictHeight, room));
            verdict.setBounds(0, top, isBeside ? width - courseWidth - gap() : width, verdictHeight);
            if (isBeside) {
                course.setBounds(width - courseWidth, top, courseWidth, courseHeight);
            } else {
                course.setBounds(0, top + verdictHeight + gap(), width, isBelow ? courseHeight : 0);
            }
        }

        /** @return top of the next part */
        private static int below(int top, int width, JComponent part, int height) {
            part.setBounds(0, top, width, height);
            return part.isVisible() ? top + height + gap() : top;
        }

        /** @return bottom of the part above */
        private static int above(int bottom, int width, JComponent part, int height) {
            part.setBounds(0, bottom - height, width, height);
            return part.isVisible() && height > 0 ? bottom - height - gap() : bottom;
        }

        private static int gap() {
            return Theme.px(GAP_UNITS);
        }
    }

    /** True if the newest reply states the order's outcome. */
    private boolean isSaidByReplies() {
        String tone = courseNow.tone().map(each -> String.valueOf(each.key())).orElse("none");
        return replies.newest().startsWith(tone);
    }

    /** One label for each reply tone of a call. */
    private static List<String> tones(String digits) {
        return digits.chars().mapToObj(digit -> String.valueOf((char) digit)).toList();
    }

    private static String newest(List<String> replies) {
        return replies.isEmpty() ? "" : replies.get(replies.size() - 1);
    }
}
