package simgsm.classroom.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.List;
import javax.swing.JTextArea;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.DressedPanel;
import simgsm.ui.ReadingArea;
import simgsm.ui.Theme;

/** The commands of the students' machines, in the largest letters that fit. Needs no display. */
final class ClassCommands extends DressedPanel {
    private static final int MARGIN_UNITS = 24;
    private static final int MOST_UNITS = 56;
    private static final int LEAST_PIXELS = 9;

    private final JTextArea text = new ReadingArea("");

    /** @param rows phones and their robots */
    ClassCommands(TextBundle words, String pattern, List<ClassView.Row> rows) {
        StringBuilder all = new StringBuilder(pattern).append("\n\n");
        rows.stream()
                .sorted((a, b) -> a.phone().compareTo(b.phone()))
                .forEach(row -> all.append(words.of(
                                "class.number", row.phone(), row.cells().get(2)))
                        .append('\n'));
        text.setText(all.toString().strip());
        ComponentNames.name(text, "class.large.text", words.of("class.commands"));
        setBorder(Theme.padding(MARGIN_UNITS));
        add(text, BorderLayout.CENTER);
        dress();
    }

    @Override
    protected void dress() {
        setBackground(Theme.color(Ink.CARD));
        text.setBackground(Theme.color(Ink.CARD));
        text.setForeground(Theme.color(Ink.TEXT));
    }

    @Override
    public void doLayout() {
        int width = getWidth() - getInsets().left - getInsets().right;
        int height = getHeight() - getInsets().top - getInsets().bottom;
        for (int pixels = Theme.px(MOST_UNITS); pixels >= LEAST_PIXELS; pixels--) {
            text.setFont(Theme.mono().deriveFont((float) pixels));
            text.setSize(width, Short.MAX_VALUE);
            Dimension needed = text.getPreferredSize();
            if (needed.height <= height && needed.width <= width) {
                break;
            }
        }
        super.doLayout();
    }
}
