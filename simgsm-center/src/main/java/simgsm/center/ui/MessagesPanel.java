package simgsm.center.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import simgsm.center.msc.ExchangeSnapshot.MessageRow;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/** The queue of messages and those that have ended recently; below, the history of the selected one. */
final class MessagesPanel extends JPanel {
    private static final int HISTORY_UNITS = 132;
    /** The history takes at most this part of the height; in a panel below {@link #LOW_UNITS} it is hidden. */
    private static final double HISTORY_SHARE = 0.35;

    private static final int LOW_UNITS = 150;

    private final TextBundle texts;
    private final RowsPanel<MessageRow> rows;
    private final JTextArea history = new JTextArea();
    private final JScrollPane scroll = new JScrollPane(history);

    MessagesPanel(TextBundle texts) {
        super(new BorderLayout());
        this.texts = texts;
        setOpaque(false);
        rows = Tables.messages(texts).onChoice(this::tell);
        ComponentNames.name(history, "message.history", texts.of("window.history"));
        history.setEditable(false);
        history.setLineWrap(true);
        history.setWrapStyleWord(true);
        history.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        history.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        history.setText(texts.of("window.history.none"));
        add(Arrange.column(8, Arrange.growing(rows), scroll), BorderLayout.CENTER);
        dress();
    }

    void show(List<MessageRow> newRows) {
        rows.show(newRows);
        rows.selected().ifPresent(this::tell);
    }

    private void tell(MessageRow row) {
        String text = String.join("\n", HistoryWords.lines(row.history(), texts));
        if (!text.equals(history.getText())) {
            history.setText(text);
            history.setCaretPosition(0);
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (scroll != null) {
            dress();
        }
    }

    /** The rows come first. */
    @Override
    public void doLayout() {
        scroll.setVisible(getHeight() >= Theme.px(LOW_UNITS));
        limitHistory();
        super.doLayout();
    }

    private void limitHistory() {
        int most = getHeight() == 0 ? Integer.MAX_VALUE : (int) (getHeight() * HISTORY_SHARE);
        scroll.setPreferredSize(new Dimension(0, Math.min(Theme.px(HISTORY_UNITS), most)));
    }

    private void dress() {
        limitHistory();
        history.setFont(Theme.base());
        history.setForeground(Theme.color(Ink.TEXT));
        history.setBorder(Theme.padding(6));
    }
}
