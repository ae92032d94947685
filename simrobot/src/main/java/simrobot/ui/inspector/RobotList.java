package simrobot.ui.inspector;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.util.List;
import java.util.function.Consumer;
import javax.accessibility.AccessibleRole;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.Drawing;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.VerticalScrollPane;
import simrobot.drawing.StatusLook;
import simrobot.ui.StatusLamps;
import vericommand.RobotStatus;

/** The list of all robots with their statuses and numbers. */
public final class RobotList {
    /**
     * A robot in the list.
     *
     * @param number of its modem, empty without one
     * @param calling true if it is in a call
     */
    public record Row(String name, RobotStatus status, String number, boolean calling) {}

    private static final int ROWS_SHOWN = 4;

    private final DefaultListModel<Row> model = new DefaultListModel<>();
    private final JList<Row> list = new JList<>(model);
    private final JScrollPane pane = new VerticalScrollPane(list);

    RobotList(TextBundle texts, Consumer<String> selection) {
        ComponentNames.name(list, "robots", texts.of("robots.name"));
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new RowRenderer(texts));
        list.setVisibleRowCount(ROWS_SHOWN);
        list.addListSelectionListener(event -> {
            if (!event.getValueIsAdjusting() && list.getSelectedValue() != null) {
                selection.accept(list.getSelectedValue().name());
            }
        });
    }

    JList<Row> list() {
        return list;
    }

    /** Selects the next or the previous robot; the first follows the last. */
    void step(int by) {
        if (!model.isEmpty()) {
            list.setSelectedIndex(Math.floorMod(list.getSelectedIndex() + by, model.size()));
            list.ensureIndexIsVisible(list.getSelectedIndex());
        }
    }

    JScrollPane component() {
        return pane;
    }

    void show(List<Row> rows, String selected) {
        for (int i = 0; i < rows.size(); i++) {
            if (i == model.size()) {
                model.addElement(rows.get(i));
            } else if (!model.get(i).equals(rows.get(i))) {
                model.set(i, rows.get(i));
            }
        }
        while (model.size() > rows.size()) {
            model.remove(model.size() - 1);
        }
        list.setVisibleRowCount(Math.max(1, Math.min(ROWS_SHOWN, rows.size())));
        for (int i = 0; i < rows.size(); i++) {
            if (rows.get(i).name().equals(selected) && list.getSelectedIndex() != i) {
                list.setSelectedIndex(i);
                list.ensureIndexIsVisible(i);
            }
        }
    }

    private static final class RowRenderer extends PaintedComponent implements ListCellRenderer<Row> {
        private final TextBundle texts;
        private Row row = new Row("", RobotStatus.STOPPED, "", false);
        private boolean chosen;

        RowRenderer(TextBundle texts) {
            super(AccessibleRole.LABEL);
            setName("robot");
            this.texts = texts;
        }

        @Override
        public Component getListCellRendererComponent(
                JList<? extends Row> list, Row value, int index, boolean isSelected, boolean hasFocus) {
            change(() -> row = value);
            chosen = isSelected;
            return this;
        }

        @Override
        protected String spoken() {
            String call = row.calling() ? " " + texts.of("robots.calling") : "";
            return row.name() + " " + StatusLamps.word(texts, row.status()) + " " + row.number() + call;
        }

        @Override
        public Dimension getPreferredSize() {
            // the list gives each row its full width; a larger preference would put the number under the scroll bar
            return new Dimension(Theme.px(120), Theme.px(26));
        }

        @Override
        protected void paint(Graphics2D g, double width, double height) {
            if (chosen) {
                g.setColor(Theme.color(Ink.ACCENT_WASH));
                g.fillRect(0, 0, getWidth(), getHeight());
            }
            double r = Theme.exact(5.5);
            StatusLook.mark(row.status())
                    .draw(new GraphicsCanvas(g), Theme.exact(8) + r, height / 2, r, StatusLook.ink(row.status()));
            double base = height / 2 + Drawing.capHeight(g, Theme.base()) / 2;
            double number = Drawing.width(Theme.mono(), row.number()) + Theme.exact(8);
            double room = width - number - Theme.exact(row.calling() ? 22 : 4);
            if (row.calling()) {
                g.setColor(Theme.color(Ink.GOOD));
                Symbol.CALL.paint(g, width - number - Theme.exact(10), height / 2, Theme.exact(12));
            }
            g.setFont(Theme.strong());
            g.setColor(Theme.color(Ink.TEXT));
            double left = Theme.exact(28);
            g.drawString(Drawing.fitted(Theme.strong(), row.name(), room - left), (float) left, (float) base);
            g.setFont(Theme.mono());
            g.setColor(Theme.color(Ink.QUIET));
            g.drawString(row.number(), (float) (width - number), (float) base);
        }
    }
}
