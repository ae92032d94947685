package simrobot.ui.panel;

import java.util.List;
import java.util.Locale;
import javax.swing.JPanel;
import simgsm.ui.Arrange;
import simgsm.ui.NumberedLabel;
import simgsm.ui.Theme;
import vericommand.ReplyTone;

/** The replies of one call or message as numbered chips with their words, the newest at the right. */
final class ReplyLabels extends JPanel {
    private final Locale language;
    private List<String> shown = List.of();
    private int room = -1;

    ReplyLabels(Locale language) {
        super(null);
        this.language = language;
        setOpaque(false);
        setName("replies");
        setLayout(new java.awt.BorderLayout());
    }

    /** @param replies as {@code 3 Done: ...} or {@code 3}, the newest last */
    void show(List<String> replies) {
        if (!replies.equals(shown)) {
            shown = replies;
            build();
        }
    }

    /** As many of the newest as fit; the chips' sizes follow the zoom, so they are laid out anew with the panel. */
    private void build() {
        removeAll();
        JPanel row = Arrange.row(6);
        int used = 0;
        for (int i = shown.size() - 1; i >= 0; i--) {
            NumberedLabel chip = chip(shown.get(i));
            used += chip.getPreferredSize().width + Theme.px(6);
            if (used > getWidth() && i < shown.size() - 1 && getWidth() > 0) {
                break;
            }
            row.add(chip, 0);
        }
        row.add(Arrange.spring());
        add(row);
        room = getWidth();
        revalidate();
        repaint();
    }

    @Override
    public void doLayout() {
        if (room != getWidth()) {
            build();
        }
        super.doLayout();
    }

    private NumberedLabel chip(String reply) {
        char number = reply.isEmpty() ? '?' : reply.charAt(0);
        String word = number >= '1' && number <= '8' ? ReplyTone.values()[number - '1'].words(language) : "";
        NumberedLabel chip = new NumberedLabel(String.valueOf(number), word, NumberedLabel.inkOfTone(number));
        chip.setName("reply." + number);
        chip.setToolTipText(reply);
        return chip;
    }

    @Override
    public java.awt.Dimension getPreferredSize() {
        return new java.awt.Dimension(Theme.px(120), Theme.px(26));
    }

    @Override
    public java.awt.Dimension getMinimumSize() {
        return getPreferredSize();
    }
}
