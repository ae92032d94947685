package simgsm.center.ui;

import java.util.List;
import java.util.Locale;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import simgsm.center.msc.ExchangeSnapshot.MessageRow;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.DressedPanel;
import simgsm.ui.ReadingArea;
import simgsm.ui.Theme;
import simgsm.ui.pane.DividedPanel;
import simgsm.ui.pane.Divider;

/** The queue of messages and the recently ended ones; below, the history of the selected one. */
final class MessagesPanel extends DressedPanel {
    private static final int HISTORY_UNITS = 132;
    /** Maximum initial share of the history in the height; a panel below {@link #LOW_UNITS} hides it. */
    private static final double HISTORY_SHARE = 0.35;

    private static final int LOW_UNITS = 150;
    /** Minimum height of rows and history when the divider is moved. */
    private static final int LEAST_UNITS = 40;

    private final TextBundle texts;
    private final RowsPanel<MessageRow> rows;
    private final JTextArea history = new ReadingArea("");
    private final JScrollPane scroll = new JScrollPane(history);

    MessagesPanel(TextBundle texts) {
        this.texts = texts;
        setOpaque(false);
        rows = Tables.messages(texts).onChoice(this::tell);
        ComponentNames.name(history, "message.history", texts.of("window.history"));
        history.setText(texts.of("window.history.none"));
        Divider divider = new Divider(
                "divider.history",
                texts.of("divider.history"),
                Locale.forLanguageTag(texts.of("window.language")),
                LEAST_UNITS);
        add(new DividedPanel(false, rows, scroll, divider, LEAST_UNITS, MessagesPanel::historyHeight));
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

    /** Gives the rows priority until the user moves the divider. */
    private static int historyHeight(int room) {
        return Math.min(Theme.px(HISTORY_UNITS), (int) (room * HISTORY_SHARE));
    }

    @Override
    public void doLayout() {
        boolean hasRoom = getHeight() >= Theme.px(LOW_UNITS);
        if (hasRoom != scroll.isVisible()) {
            scroll.setVisible(hasRoom);
        }
        super.doLayout();
    }

    @Override
    protected void dress() {
        history.setFont(Theme.base());
        history.setForeground(Theme.color(Ink.TEXT));
        history.setBorder(Theme.padding(6));
    }
}
