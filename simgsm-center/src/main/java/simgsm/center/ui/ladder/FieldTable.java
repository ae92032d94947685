package simgsm.center.ui.ladder;

import java.awt.Component;
import java.awt.Dimension;
import java.util.List;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.ListSelectionModel;
import javax.swing.table.DefaultTableModel;
import javax.swing.table.TableCellRenderer;
import simgsm.draw.Ink;
import simgsm.trace.MessageText.Field;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

/** The fields of a message, name and value; a long value wraps below its beginning. */
final class FieldTable extends JTable {
    private static final int LEAST_VALUE_UNITS = 120;
    private final Cell cell = new Cell();
    private int laidOutWidth = -1;

    FieldTable() {
        super(new DefaultTableModel(0, 2) {
            @Override
            public boolean isCellEditable(int row, int column) {
                return false;
            }
        });
        setName("ladder.detail");
        setTableHeader(null);
        setShowGrid(false);
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setAutoResizeMode(AUTO_RESIZE_LAST_COLUMN);
        setIntercellSpacing(new Dimension());
        setFillsViewportHeight(true);
    }

    void show(List<Field> fields) {
        DefaultTableModel model = (DefaultTableModel) getModel();
        model.setRowCount(0);
        fields.forEach(field -> model.addRow(new Object[] {field.name(), field.value()}));
        laidOutWidth = -1;
        fit();
        revalidate();
    }

    private void fit() {
        int width = getWidth();
        if (width == laidOutWidth || getColumnCount() < 2) {
            return;
        }
        laidOutWidth = width;
        int names = 0;
        for (int row = 0; row < getRowCount(); row++) {
            names = Math.max(names, Drawing.width(Theme.base(), String.valueOf(getValueAt(row, 0))));
        }
        names += Theme.px(20);
        getColumnModel().getColumn(0).setMinWidth(names);
        getColumnModel().getColumn(0).setMaxWidth(names);
        int values = Math.max(Theme.px(LEAST_VALUE_UNITS), width - names);
        for (int row = 0; row < getRowCount(); row++) {
            setRowHeight(row, Math.max(Theme.px(20), cell.heightOf(getValueAt(row, 1), values)));
        }
    }

    @Override
    public void doLayout() {
        fit();
        super.doLayout();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        // installed again, because a look-and-feel change removes renderers
        setDefaultRenderer(Object.class, new Cell());
        laidOutWidth = -1;
        setBackground(Theme.color(Ink.CARD));
    }

    private static final class Cell extends JTextArea implements TableCellRenderer {
        Cell() {
            setLineWrap(true);
            setWrapStyleWord(true);
        }

        int heightOf(Object value, int width) {
            dress(value, false);
            setSize(width, Short.MAX_VALUE);
            return getPreferredSize().height;
        }

        private void dress(Object value, boolean isName) {
            setText(String.valueOf(value));
            setFont(Theme.base());
            setBorder(Theme.padding(2, 6, 2, 4));
            setForeground(Theme.color(isName ? Ink.QUIET : Ink.TEXT));
        }

        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean selected, boolean focused, int row, int column) {
            dress(value, column == 0);
            setBackground(Theme.color(selected ? Ink.ACCENT_WASH : Ink.CARD));
            return this;
        }
    }
}
