package simgsm.center.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTextArea;
import simgsm.center.msc.ExchangeSnapshot.MessageRow;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/** The queue of messages and those that have ended recently; below, the history of the selected one. */
final class MessagesPanel extends JPanel {
    private static final int HISTORY_UNITS = 132;
    /** The history takes at most this part of the height at first; in a panel below {@link #LOW_UNITS} it is hidden. */
    private static final double HISTORY_SHARE = 0.35;

    private static final int LOW_UNITS = 150;

    private final TextBundle texts;
    private final RowsPanel<MessageRow> rows;
    private final JTextArea history = new JTextArea();
    private final JSplitPane split;
    private boolean isPlaced;
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
        rows.setMinimumSize(new Dimension(0, 0));
        scroll.setMinimumSize(new Dimension(0, 0));
        split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, rows, scroll);
        split.setResizeWeight(1);
        split.setBorder(null);
        split.setOpaque(false);
        add(split, BorderLayout.CENTER);
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
        if (split != null) {
            dress();
        }
    }

    /** The rows come first, until the user moves the divider. */
    @Override
    public void doLayout() {
        super.doLayout();
        boolean hasRoom = getHeight() >= Theme.px(LOW_UNITS);
        if (hasRoom != scroll.isVisible() || !isPlaced && getHeight() > 0) {
            isPlaced = true;
            scroll.setVisible(hasRoom);
            split.setDividerSize(hasRoom ? Theme.px(Theme.GRID) : 0);
            int history = Math.min(Theme.px(HISTORY_UNITS), (int) (getHeight() * HISTORY_SHARE));
            split.setDividerLocation(hasRoom ? getHeight() - split.getDividerSize() - history : getHeight());
            split.doLayout();
        }
    }

    private void dress() {
        history.setFont(Theme.base());
        history.setForeground(Theme.color(Ink.TEXT));
        history.setBorder(Theme.padding(6));
    }
}
