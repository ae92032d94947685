package simgsm.center.ui.ladder;

import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractListModel;
import simgsm.center.msc.LadderEntry;

/**
 * The messages shown: those of the snapshots, without cleared and filtered ones. With several columns, empty elements
 * precede the first message, so that the last column is full.
 */
final class LadderModel extends AbstractListModel<LadderRow> {
    private final List<LadderRow> rows = new ArrayList<>();
    private List<LadderEntry> entries = List.of();
    private long count;
    private long lastNumber;
    private long clearedUpTo;
    /** Value before the last clearing, for its undo. */
    private long clearedBefore;

    private LadderFilter filter = LadderFilter.ALL;
    private boolean isPaused;
    private List<LadderEntry> newestEntries = List.of();
    private long newestCount;
    private int rowsPerColumn = 1;
    private int columns = 1;
    /** Number of leading empty elements. */
    private int blanks;

    /**
     * Applies a snapshot: removes rows that the snapshot no longer has and adds new ones, so that a selection is kept.
     *
     * @param newEntries the latest ones, oldest first
     * @param newCount the number of the last one
     */
    void update(List<LadderEntry> newEntries, long newCount) {
        newestEntries = newEntries;
        newestCount = newCount;
        if (!isPaused) {
            take(newEntries, newCount);
        }
    }

    private void take(List<LadderEntry> newEntries, long newCount) {
        boolean isAnotherExchange = newCount < count;
        entries = newEntries;
        count = newCount;
        if (isAnotherExchange) {
            clearedUpTo = 0;
            clearedBefore = 0;
            rebuild();
        }
        dropBefore(numberOf(0));
        rename();
        add();
    }

    /** Keeps the rows during a pause, and adds all missed messages after it. */
    void pause(boolean paused) {
        isPaused = paused;
        if (!paused) {
            take(newestEntries, newestCount);
        }
    }

    /** Number of messages missed since the pause began; 0 without one. */
    long heldBack() {
        return isPaused ? Math.max(0, newestCount - count) : 0;
    }

    void filter(LadderFilter newFilter) {
        if (!newFilter.equals(filter)) {
            filter = newFilter;
            rebuild();
        }
    }

    /** Hides all messages so far. */
    void clear() {
        clearedBefore = clearedUpTo;
        clearedUpTo = count;
        rebuild();
    }

    /** True if {@link #unclear} would show more messages. */
    boolean isCleared() {
        return clearedUpTo > clearedBefore;
    }

    /** Undoes the last {@link #clear}. */
    void unclear() {
        clearedUpTo = clearedBefore;
        rebuild();
    }

    /** The rows in order. */
    List<LadderRow> rows() {
        return List.copyOf(rows);
    }

    /** The terminals of all messages that were not cleared, filtered or not, the latest first. */
    List<String> terminals() {
        List<String> found = new ArrayList<>();
        for (int i = entries.size() - 1; i >= 0 && numberOf(i) > clearedUpTo; i--) {
            String name = new LadderRow(0, entries.get(i)).terminal();
            if (!found.contains(name)) {
                found.add(name);
            }
        }
        return found;
    }

    private void rebuild() {
        int size = getSize();
        rows.clear();
        blanks = 0;
        if (size > 0) {
            fireIntervalRemoved(this, 0, size - 1);
        }
        lastNumber = clearedUpTo;
        add();
    }

    private void dropBefore(long number) {
        int dropped = 0;
        while (dropped < rows.size() && rows.get(dropped).number() < number) {
            dropped++;
        }
        if (dropped > 0) {
            rows.subList(0, dropped).clear();
            fireIntervalRemoved(this, blanks, blanks + dropped - 1);
            fillUp();
        }
    }

    /** Sets the number of columns and of rows per column. */
    void arrange(int newColumns, int newRowsPerColumn) {
        columns = newColumns;
        rowsPerColumn = newRowsPerColumn;
        fillUp();
    }

    private void fillUp() {
        boolean isWhole = columns == 1 || rows.size() <= columns * rowsPerColumn;
        int wanted = isWhole ? 0 : Math.floorMod(-rows.size(), rowsPerColumn);
        int before = blanks;
        blanks = wanted;
        if (wanted > before) {
            fireIntervalAdded(this, 0, wanted - before - 1);
        } else if (wanted < before) {
            fireIntervalRemoved(this, 0, before - wanted - 1);
        }
    }

    /** Adds a newly known number of a terminal to its earlier messages. */
    private void rename() {
        for (int i = 0; i < rows.size(); i++) {
            LadderRow row = rows.get(i);
            LadderEntry now = entries.get((int) (row.number() - numberOf(0)));
            if (now != row.entry() && !now.equals(row.entry())) {
                rows.set(i, new LadderRow(row.number(), now));
                fireContentsChanged(this, blanks + i, blanks + i);
            }
        }
    }

    private void add() {
        int before = rows.size();
        int seen = (int) Math.max(0, lastNumber + 1 - numberOf(0));
        for (int i = seen; i < entries.size(); i++) {
            LadderRow row = new LadderRow(numberOf(i), entries.get(i));
            if (filter.accepts(row)) {
                rows.add(row);
            }
        }
        lastNumber = count;
        if (rows.size() > before) {
            fireIntervalAdded(this, blanks + before, getSize() - 1);
            fillUp();
        }
    }

    private long numberOf(int index) {
        return count - entries.size() + 1 + index;
    }

    /** The index of the first message, after the empty elements. */
    int firstIndex() {
        return blanks;
    }

    @Override
    public int getSize() {
        return blanks + rows.size();
    }

    /** A row; null for an empty element. */
    @Override
    public LadderRow getElementAt(int index) {
        return index < blanks ? null : rows.get(index - blanks);
    }
}
