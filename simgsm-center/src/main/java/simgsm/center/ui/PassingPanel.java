package simgsm.center.ui;

import java.awt.BorderLayout;
import java.util.Locale;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextField;
import simgsm.air.LocationArea;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.msc.call.CallView;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DressedPanel;
import simgsm.ui.ReadingField;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;

/**
 * The panel of the paper's figure 4, live: the calling or sending telephone (TEL entrante), the centre (TEL
 * intermedio), the called or receiving telephone (TEL saliente), and the message.
 */
final class PassingPanel extends DressedPanel {
    private static final int ONE_ROW_UNITS = 860;
    private static final int MESSAGE_COLUMNS = 8;
    /** For numbers of 10 digits, and for area and port. */
    private static final int NUMBER_COLUMNS = 11;

    private final TextBundle texts;
    private final JTextField incoming = new ReadingField(NUMBER_COLUMNS);
    private final JTextField intermediate = new ReadingField(NUMBER_COLUMNS);
    private final JTextField outgoing = new ReadingField(NUMBER_COLUMNS);
    private final JTextField message = new ReadingField(MESSAGE_COLUMNS);
    private final JLabel firstArrow = new JLabel(Symbol.RIGHT.icon());
    private final JLabel secondArrow = new JLabel(Symbol.RIGHT.icon());
    private final JComponent numbers;
    private final JComponent text;
    private boolean isOneRow;

    PassingPanel(TextBundle texts, int port) {
        this.texts = texts;
        setOpaque(false);
        numbers = Arrange.row(
                8,
                Arrange.growing(labelled(incoming, "window.tel.incoming")),
                firstArrow,
                labelled(intermediate, "window.tel.intermediate"),
                secondArrow,
                Arrange.growing(labelled(outgoing, "window.tel.outgoing")));
        text = labelled(message, "window.message");
        arrange(false);
        set(intermediate, String.format(Locale.ROOT, "%04d %d", LocationArea.TEST.areaCode(), port));
        name("tel.incoming", incoming, "window.tel.incoming");
        name("tel.intermediate", intermediate, "window.tel.intermediate");
        name("tel.outgoing", outgoing, "window.tel.outgoing");
        name("message", message, "window.message");
        dress();
    }

    private void name(String name, JTextField field, String key) {
        ComponentNames.name(field, name, texts.of(key));
        field.setToolTipText(texts.of(key + ".why"));
    }

    private JComponent labelled(JTextField field, String key) {
        JLabel label = new JLabel(texts.of(key));
        label.setLabelFor(field);
        return Arrange.row(6, label, Arrange.growing(field));
    }

    private void arrange(boolean oneRow) {
        isOneRow = oneRow;
        removeAll();
        add(
                oneRow ? Arrange.row(8, numbers, Arrange.growing(text)) : Arrange.column(8, numbers, text),
                BorderLayout.CENTER);
        revalidate();
    }

    /** Puts all fields in one row if the window is wide. */
    @Override
    public void doLayout() {
        boolean hasRoom = getWidth() >= Theme.px(ONE_ROW_UNITS);
        if (hasRoom != isOneRow) {
            arrange(hasRoom);
        }
        super.doLayout();
    }

    void show(ExchangeSnapshot snapshot) {
        snapshot.latest().ifPresent(passing -> {
            set(incoming, passing.from().digits());
            set(outgoing, passing.to());
            setToEnd(message, passing.text().isEmpty() ? callWord(snapshot, passing) : passing.text());
        });
    }

    /** The state of the call, or the word for its end. */
    private String callWord(ExchangeSnapshot snapshot, ExchangeSnapshot.Passing passing) {
        return snapshot.calls().stream()
                .filter(call -> call.from().equals(passing.from()) && call.to().equals(passing.to()))
                .findFirst()
                .map(CallView::state)
                .map(state -> texts.of(
                        "window.passing.call", Tables.word(state, texts).word()))
                .orElseGet(() -> texts.of("window.passing.over"));
    }

    private static void set(JTextField field, String text) {
        if (!field.getText().equals(text)) {
            field.setText(text);
            field.setCaretPosition(0);
        }
    }

    /** Shows the end of a growing text. */
    private static void setToEnd(JTextField field, String text) {
        boolean grows = !field.getText().isEmpty() && text.startsWith(field.getText());
        if (!field.getText().equals(text)) {
            field.setText(text);
            field.setCaretPosition(grows ? text.length() : 0);
        }
    }

    @Override
    protected void dress() {
        firstArrow.setForeground(Theme.color(Ink.QUIET));
        secondArrow.setForeground(Theme.color(Ink.QUIET));
        for (JTextField field : new JTextField[] {incoming, intermediate, outgoing, message}) {
            field.setFont(Theme.mono());
        }
    }
}
