package simgsm.center.ui;

import java.util.List;
import java.util.function.Function;
import javax.swing.table.AbstractTableModel;

/** The rows of a snapshot as a table. */
final class RowsModel<T> extends AbstractTableModel {
    private final List<Column<T>> columns;
    private List<T> rows = List.of();

    RowsModel(List<Column<T>> columns) {
        this.columns = List.copyOf(columns);
    }

    /** @return true if a row has changed */
    boolean update(List<T> newRows) {
        if (newRows.equals(rows)) {
            return false;
        }
        rows = newRows;
        fireTableDataChanged();
        return true;
    }

    T row(int index) {
        return rows.get(index);
    }

    int indexOf(T row, Function<T, Object> identity) {
        Object wanted = identity.apply(row);
        for (int i = 0; i < rows.size(); i++) {
            if (identity.apply(rows.get(i)).equals(wanted)) {
                return i;
            }
        }
        return -1;
    }

    @Override
    public int getRowCount() {
        return rows.size();
    }

    @Override
    public int getColumnCount() {
        return columns.size();
    }

    @Override
    public String getColumnName(int column) {
        return columns.get(column).title();
    }

    @Override
    public Object getValueAt(int row, int column) {
        return columns.get(column).value().apply(rows.get(row));
    }
}
