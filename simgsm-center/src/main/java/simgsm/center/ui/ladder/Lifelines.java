package simgsm.center.ui.ladder;

import java.util.ArrayList;
import java.util.List;
import simgsm.center.msc.LadderEntry;
import simgsm.ui.Theme;

/**
 * The order of the lifelines: the centre in the middle, terminals in the order of their numbers on both sides. The
 * names of messages stand beside the centre: with more than two terminals the lines are closer to each other than to the centre.
 *
 * <pre>
 *   | time |  5550100  5550101      M3      5550200  5550201  | tag |
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

    /** Gap beside the centre that any message name fits into. */
    private static final int NAME_UNITS = 240;

    /** Up to this gap the numbers above other lines are cut first. */
    private static final int FIRST_UNITS = 150;

    private static final int LEAST_NAME_UNITS = 96;
    /** Gap beside the centre in several columns: most message names fit. */
    private static final int COLUMN_NAME_UNITS = 108;
    /** Gap of other lines: a number of 7 digits fits above them, of longer ones the end. */
    private static final int OUTER_UNITS = 84;

    /** The last three digits of a number fit. */
    private static final int LEAST_OUTER_UNITS = 52;

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
        if (names.size() == 1) {
            return first + centerGap(width) / 2;
        }
        int center = names.indexOf(LadderEntry.CENTER);
        int outer = Math.min(index, Math.max(0, center - 1)) + Math.max(0, index - center - 1);
        return first + outerGap(width) * outer + centerGap(width) * (index - outer);
    }

    /** Distance of the centre's line from those beside it, in units. */
    double centerGap(double width) {
        double even = room(width) / (centerGaps() + outerGaps());
        double beside = (room(width) - OUTER_UNITS * outerGaps()) / centerGaps();
        double most = (room(width) - LEAST_OUTER_UNITS * outerGaps()) / centerGaps();
        double shared = Math.max(beside, Math.min(FIRST_UNITS, most));
        return outerGaps() == 0 ? even : Math.max(even, Math.min(NAME_UNITS, shared));
    }

    /** Least distance of two lines, in units. */
    double outerGap(double width) {
        return outerGaps() == 0 ? centerGap(width) : (room(width) - centerGap(width) * centerGaps()) / outerGaps();
    }

    private static double room(double width) {
        return width - (TIME_UNITS + TAG_UNITS + 2 * HALF_HEAD_UNITS);
    }

    private int centerGaps() {
        return Math.max(1, Math.min(2, names.size() - 1));
    }

    private int outerGaps() {
        return Math.max(0, names.size() - 3);
    }

    /**
     * The room for message names on one side of the centre, in units: up to the line beside it, or to the column beyond
     * if there is no other; between the columns if each side has one line at most.
     */
    Range nameRoom(boolean isLeft, double width) {
        double center = x(LadderEntry.CENTER, width);
        int beside = names.indexOf(LadderEntry.CENTER) + (isLeft ? -1 : 1);
        boolean hasOther = beside > 0 && beside < names.size() - 1;
        double left = isLeft && hasOther ? x(names.get(beside), width) : TIME_UNITS;
        double right = !isLeft && hasOther ? x(names.get(beside), width) : width - TAG_UNITS;
        boolean isWide = outerGaps() == 0;
        return new Range(isLeft || isWide ? left : center, isLeft && !isWide ? center : right);
    }

    /** Two positions in units. */
    record Range(double left, double right) {}

    /** The minimum width, in pixels. */
    int leastWidth() {
        return widthFor(LEAST_NAME_UNITS, LEAST_OUTER_UNITS);
    }

    /** The minimum width of one of several columns, in pixels. */
    int leastColumnWidth() {
        return widthFor(COLUMN_NAME_UNITS, OUTER_UNITS);
    }

    private int widthFor(int nameUnits, int outerUnits) {
        int fixed = TIME_UNITS + TAG_UNITS + 2 * HALF_HEAD_UNITS;
        return Theme.px(fixed + nameUnits * centerGaps() + outerUnits * outerGaps());
    }
}
