package simrobot.ui.telephone;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.List;
import java.util.Locale;
import javax.swing.JPanel;
import simgsm.ui.Arrange;
import simgsm.ui.NumberedLabel;
import simgsm.ui.Theme;
import vericommand.ReplyTone;

/** The replies of one call or message as numbered labels with their words, newest at the right. */
final class ReplyLabels extends JPanel {
    private final Locale language;
    private List<String> shown = List.of();
    private int builtWidth = -1;

    ReplyLabels(Locale language) {
        super(new BorderLayout());
        this.language = language;
        setOpaque(false);
        setName("replies");
    }

    /** @param replies as {@code 3 Done: ...} or {@code 3}, newest last */
    void show(List<String> replies) {
        if (!replies.equals(shown)) {
            shown = replies;
            build();
        }
    }

    /** Empty if there is none. */
    String newest() {
        return shown.isEmpty() ? "" : shown.get(shown.size() - 1);
    }

    /** Adds labels, newest first, while they fit; repeated after a change of the panel's width. */
    private void build() {
        removeAll();
        JPanel row = Arrange.row(6);
        int used = 0;
        for (int i = shown.size() - 1; i >= 0; i--) {
            NumberedLabel label = label(shown.get(i));
            used += label.getPreferredSize().width + Theme.px(6);
            if (used > getWidth() && i < shown.size() - 1 && getWidth() > 0) {
                break;
            }
            row.add(label, 0);
        }
        row.add(Arrange.spring());
        add(row);
        builtWidth = getWidth();
        revalidate();
        repaint();
    }

    @Override
    public void doLayout() {
        if (builtWidth != getWidth()) {
            build();
        }
        super.doLayout();
    }

    private NumberedLabel label(String reply) {
        char number = reply.isEmpty() ? '?' : reply.charAt(0);
        String word = number >= '1' && number <= '8' ? ReplyTone.values()[number - '1'].words(language) : "";
        NumberedLabel label = new NumberedLabel(String.valueOf(number), word, NumberedLabel.inkOfTone(number));
        label.setName("reply." + number);
        label.setToolTipText(reply);
        return label;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(120), Theme.px(26));
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }
}
