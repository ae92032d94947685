package simgsm.center.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.Icon;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableColumn;
import simgsm.air.Msisdn;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.Drawing;
import simgsm.ui.DressedPanel;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.Theme;

/** A table of a snapshot's rows, with a text for the empty table. */
final class RowsPanel<T> extends DressedPanel {
    /** The first columns keep their width in a narrow window. */
    private static final int FIRM_COLUMNS = 2;

    private final RowsModel<T> model;
    private final JTable table;
    private final List<Column<T>> columns;
    /** The part of a row that survives changes. */
    private Function<T, Object> identity = row -> row;

    /** @param name of the component; @param title for assistive technology; @param empty text without rows */
    RowsPanel(String name, String title, String empty, List<Column<T>> columns) {
        setOpaque(false);
        model = new RowsModel<>(columns);
        table = ComponentNames.name(new EmptyTable(empty), name, title);
        table.setModel(model);
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.setFillsViewportHeight(true);
        table.getTableHeader().setReorderingAllowed(false);
        this.columns = columns;
        add(new JScrollPane(table), BorderLayout.CENTER);
        dress();
    }

    /** Keeps a changed row selected if this is equal. */
    RowsPanel<T> identifiedBy(Function<T, Object> newIdentity) {
        identity = newIdentity;
        return this;
    }

    /** Calls back with the selected row. */
    RowsPanel<T> onChoice(Consumer<T> choice) {
        table.getSelectionModel().addListSelectionListener(event -> {
            if (!event.getValueIsAdjusting()) {
                selected().ifPresent(choice);
            }
        });
        return this;
    }

    /** Shows the rows; keeps the selection if its row still exists. */
    void show(List<T> rows) {
        Optional<T> chosen = selected();
        if (model.update(rows) && chosen.isPresent()) {
            int index = model.indexOf(chosen.get(), identity);
            if (index >= 0) {
                table.setRowSelectionInterval(index, index);
            }
        }
    }

    Optional<T> selected() {
        int row = table.getSelectedRow();
        return row < 0 ? Optional.empty() : Optional.of(model.row(row));
    }

    @Override
    protected void dress() {
        table.setRowHeight(Theme.px(28));
        table.setIntercellSpacing(new Dimension(0, 0));
        table.getTableHeader().setFont(Theme.small());
        for (int i = 0; i < columns.size(); i++) {
            TableColumn column = table.getColumnModel().getColumn(i);
            int width = Theme.px(columns.get(i).width());
            column.setMinWidth(i < FIRM_COLUMNS ? width : 0);
            column.setPreferredWidth(width);
        }
    }

    private static final class EmptyTable extends JTable {
        private final String empty;

        EmptyTable(String empty) {
            this.empty = empty;
        }

        /** Restores the renderers, which a look-and-feel change removes. */
        @Override
        public void updateUI() {
            super.updateUI();
            setDefaultRenderer(Object.class, new CellRenderer());
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            super.paintComponent(graphics);
            if (getRowCount() == 0) {
                Graphics2D g = Drawing.on(graphics);
                try {
                    g.setColor(Theme.color(Ink.QUIET));
                    Drawing.centred(g, empty, Theme.base(), getWidth() / 2.0, Theme.exact(48));
                } finally {
                    g.dispose();
                }
            }
        }
    }

    private static final class CellRenderer extends DefaultTableCellRenderer {
        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean selected, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, selected, focused, row, column);
            boolean isState = value instanceof StateWord;
            setIcon(isState ? icon((StateWord) value) : null);
            setIconTextGap(Theme.px(8));
            setFont(font(value));
            setBorder(Theme.padding(0, 6, 0, 2));
            setToolTipText(String.valueOf(value));
            if (value instanceof Digits) {
                int room = table.getColumnModel().getColumn(column).getWidth() - Theme.px(12);
                setText(Drawing.fittedEnd(getFont(), String.valueOf(value), room));
            }
            return this;
        }

        private static Font font(Object value) {
            if (value instanceof Digits) {
                return Theme.monoSmall();
            }
            return value instanceof Msisdn ? Theme.mono() : Theme.base();
        }

        private static Icon icon(StateWord state) {
            return new Icon() {
                @Override
                public void paintIcon(Component component, Graphics graphics, int x, int y) {
                    Graphics2D g = Drawing.on(graphics);
                    try {
                        double radius = getIconWidth() / 2.0;
                        state.mark().draw(new GraphicsCanvas(g), x + radius, y + radius, radius - 1, state.ink());
                    } finally {
                        g.dispose();
                    }
                }

                @Override
                public int getIconWidth() {
                    return Theme.px(12);
                }

                @Override
                public int getIconHeight() {
                    return Theme.px(12);
                }
            };
        }
    }
}
