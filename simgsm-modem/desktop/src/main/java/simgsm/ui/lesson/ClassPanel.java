package simgsm.ui.lesson;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.DefaultTableModel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;

/** The results of a class, the best first. Needs no display. */
public final class ClassPanel extends JPanel {
    /** Numbers of seven digits have to be seen whole. */
    private static final int[] WIDTHS_UNITS = {76, 76, 54, 48, 66, 66};

    private final DefaultTableModel model;

    public ClassPanel(Locale language) {
        super(new BorderLayout());
        TextBundle words = DesktopTexts.in(language);
        Object[] titles = Stream.of("phone", "robot", "orders", "keys", "collisions", "seconds")
                .map(column -> words.of("class." + column))
                .toArray();
        model = new DefaultTableModel(titles, 0);
        JTable table = ComponentNames.name(new JTable(model), "class.table", words.of("class.title"));
        table.setDefaultEditor(Object.class, null);
        table.setRowHeight(Theme.px(24));
        for (int column = 0; column < WIDTHS_UNITS.length; column++) {
            table.getColumnModel().getColumn(column).setPreferredWidth(Theme.px(WIDTHS_UNITS[column]));
        }
        GlossaryText about = new GlossaryText("class.about", Optional.empty(), term -> {});
        about.show(words.of("class.about"));
        JPanel column = Arrange.column(Theme.GRID, about, Arrange.growing(new JScrollPane(table)));
        column.setBorder(Theme.padding(12));
        add(column, BorderLayout.CENTER);
        setBackground(Theme.color(Ink.SURFACE));
    }

    /** Shows the newest results: phone, robot, orders, keys, collisions, seconds of each student. */
    public void show(List<List<String>> rows) {
        model.setRowCount(0);
        rows.forEach(row -> model.addRow(row.toArray()));
    }
}
