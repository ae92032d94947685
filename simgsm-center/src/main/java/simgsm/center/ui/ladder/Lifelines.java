package simgsm.center.ui.ladder;

import java.util.ArrayList;
import java.util.List;
import simgsm.center.msc.LadderEntry;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

/**
 * The order of the lifelines: the centre in the middle, terminals in the order of their numbers on both sides.
 *
 * <pre>
 *   | time |   5550100      M3      5550200   | tag |
 * </pre>
 */
record Lifelines(List<String> names) {
    /** Maximum with space for names; terminals of the latest messages have a lifeline. */
    static final int MAX_TERMINALS = 7;

    /** Columns left and right of the lines, in units. */
    static final int TIME_UNITS = 92;

    static final int TAG_UNITS = 38;
    /** Distance of the outer lines from the columns, for the names above them. */
    private static final int HALF_HEAD_UNITS = 44;

    private static final int LEAST_GAP_UNITS = 72;
    /** Gap in several columns: most message names fit between two lines, none covers a neighbour's. */
    private static final int COLUMN_GAP_UNITS = 108;
    /** Space around a name: its box, and the distance to the next. */
    static final int HEAD_MARGIN_UNITS = 24;

    static final Lifelines NONE = new Lifelines(List.of(LadderEntry.CENTER));

    /** @param terminals the latest first */
    static Lifelines of(List<String> terminals) {
        List<String> names = new ArrayList<>(terminals.subList(0, Math.min(MAX_TERMINALS, terminals.size())));
        names.sort(String::compareTo);
        names.add((names.size() + 1) / 2, LadderEntry.CENTER);
        return new Lifelines(List.copyOf(names));
    }

    /** X of a line in units, in a ladder of this width; -1 for a terminal without one. */
    double x(String name, double width) {
        int index = names.indexOf(name);
        if (index < 0) {
            return -1;
        }
        double first = TIME_UNITS + HALF_HEAD_UNITS;
        return names.size() == 1 ? first + gap(width) / 2 : first + gap(width) * index;
    }

    /** Distance of two lines in units. */
    double gap(double width) {
        double room = width - (TIME_UNITS + TAG_UNITS + 2 * HALF_HEAD_UNITS);
        return room / Math.max(1, names.size() - 1);
    }

    /** The minimum width at which the longest name above a line is not truncated, in pixels. */
    int leastWidth() {
        return widthFor(LEAST_GAP_UNITS);
    }

    /** The minimum width of a column, in pixels. */
    int leastColumnWidth() {
        return widthFor(COLUMN_GAP_UNITS);
    }

    private int widthFor(int gapUnits) {
        double widest = names.stream()
                .mapToDouble(name -> Drawing.width(Theme.monoStrong(), name))
                .max()
                .orElse(0);
        double gap = Math.max(Theme.exact(gapUnits), widest + Theme.exact(HEAD_MARGIN_UNITS));
        int gaps = Math.max(1, names.size() - 1);
        return (int) Math.ceil(Theme.exact(TIME_UNITS + TAG_UNITS + 2 * HALF_HEAD_UNITS) + gap * gaps);
    }
}
