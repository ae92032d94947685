package simgsm.cells.mobile;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The choice of a cell in idle mode (TS 45.008, 6), as a core: levels and time in, the serving cell out. Levels are averaged
 * over the last 8 measurements of 480 ms.
 */
public final class IdleSelection {
    /** No cell. */
    public static final int NONE = -1;

    private static final int AVERAGED = 8;
    /** Number of cells whose C2 is tracked. */
    private static final int STRONGEST = 6;

    private static final double SECOND_NANOS = 1e9;
    /** Time for which another cell must be better, or the serving one too weak. */
    private static final long DECISION_NANOS = 5_000_000_000L;
    /** Time after a change of cell in which another one needs 5 dB. */
    private static final long SETTLING_NANOS = 15_000_000_000L;

    private static final double SETTLING_DECIBELS = 5;
    private static final long NEVER = Long.MIN_VALUE;

    private final double[][] history;
    private final double[] averages;
    private final double[] c2;
    private final boolean[] isStrong;
    private final long[] strongSince;
    /** Times at which each cell became better than the serving one. */
    private final long[] betterSince;

    private int measurements;
    private int serving = NONE;
    private long weakSince = NEVER;
    private long changedNanos = NEVER;

    /** @param cells their number */
    public IdleSelection(int cells) {
        history = new double[AVERAGED][cells];
        averages = new double[cells];
        c2 = new double[cells];
        isStrong = new boolean[cells];
        strongSince = new long[cells];
        betterSince = new long[cells];
        Arrays.fill(betterSince, NEVER);
    }

    /** The cell's index; {@link #NONE} if none is suitable. */
    public int serving() {
        return serving;
    }

    /** C2 of a cell at the last measurement. */
    public double c2(int cell) {
        return c2[cell];
    }

    /** Camps on the cell of an ended connection; discards earlier measurements and times. */
    public void camp(int cell, long nowNanos) {
        measurements = 0;
        change(cell, nowNanos);
    }

    /**
     * Evaluates a measurement.
     *
     * @param levels of all cells in dBm
     * @param cells broadcast parameters; null for an unusable cell
     * @return true if the serving cell has changed
     */
    public boolean measured(long nowNanos, double[] levels, CellParameters[] cells) {
        average(levels);
        evaluate(nowNanos, cells);
        int before = serving;
        if (serving == NONE || cells[serving] == null) {
            chooseBest(nowNanos, cells);
        } else {
            reselect(nowNanos, cells);
        }
        return serving != before;
    }

    private void average(double[] levels) {
        System.arraycopy(levels, 0, history[measurements % AVERAGED], 0, levels.length);
        measurements++;
        int count = Math.min(measurements, AVERAGED);
        for (int cell = 0; cell < averages.length; cell++) {
            double sum = 0;
            for (int i = 0; i < count; i++) {
                sum += history[i][cell];
            }
            averages[cell] = sum / count;
        }
    }

    private void evaluate(long nowNanos, CellParameters[] cells) {
        double threshold = sixthStrongest(cells);
        for (int cell = 0; cell < cells.length; cell++) {
            boolean strong = cells[cell] != null && averages[cell] >= threshold;
            if (strong && !isStrong[cell]) {
                strongSince[cell] = nowNanos;
            }
            isStrong[cell] = strong;
            double known = cell == serving ? Double.POSITIVE_INFINITY : (nowNanos - strongSince[cell]) / SECOND_NANOS;
            c2[cell] = strong || cell == serving && cells[cell] != null
                    ? cells[cell].c2(averages[cell], known)
                    : Double.NEGATIVE_INFINITY;
        }
    }

    private double sixthStrongest(CellParameters[] cells) {
        double[] usable = IntStream.range(0, cells.length)
                .filter(cell -> cells[cell] != null)
                .mapToDouble(cell -> averages[cell])
                .sorted()
                .toArray();
        return usable.length <= STRONGEST ? Double.NEGATIVE_INFINITY : usable[usable.length - STRONGEST];
    }

    /** Selects the best suitable cell by C2 at once (TS 43.022, 4.5). */
    private void chooseBest(long nowNanos, CellParameters[] cells) {
        int best = NONE;
        for (int cell = 0; cell < cells.length; cell++) {
            if (cells[cell] != null && cells[cell].c1(averages[cell]) > 0 && (best == NONE || c2[cell] > c2[best])) {
                best = cell;
            }
        }
        change(best, nowNanos);
    }

    private void reselect(long nowNanos, CellParameters[] cells) {
        int best = NONE;
        for (int cell = 0; cell < cells.length; cell++) {
            boolean isBetter = cell != serving
                    && cells[cell] != null
                    && cells[cell].c1(averages[cell]) > 0
                    && c2[cell] > c2[serving] + margin(nowNanos, cells[serving], cells[cell]);
            if (!isBetter) {
                betterSince[cell] = NEVER;
            } else if (betterSince[cell] == NEVER) {
                betterSince[cell] = nowNanos;
            }
            if (isBetter && nowNanos - betterSince[cell] >= DECISION_NANOS && (best == NONE || c2[cell] > c2[best])) {
                best = cell;
            }
        }
        if (best != NONE) {
            change(best, nowNanos);
        } else {
            leaveIfWeak(nowNanos, cells);
        }
    }

    /** Required advantage of another cell in dB: the larger margin of the two exceptions (TS 45.008, 6.6.2). */
    private double margin(long nowNanos, CellParameters from, CellParameters to) {
        double hysteresis = from.area() == to.area() ? 0 : from.hysteresisDecibels();
        boolean isSettling = changedNanos != NEVER && nowNanos - changedNanos < SETTLING_NANOS;
        return Math.max(hysteresis, isSettling ? SETTLING_DECIBELS : 0);
    }

    private void leaveIfWeak(long nowNanos, CellParameters[] cells) {
        if (cells[serving].c1(averages[serving]) >= 0) {
            weakSince = NEVER;
        } else if (weakSince == NEVER) {
            weakSince = nowNanos;
        } else if (nowNanos - weakSince >= DECISION_NANOS) {
            chooseBest(nowNanos, cells);
        }
    }

    private void change(int cell, long nowNanos) {
        if (cell != serving) {
            changedNanos = serving == NONE ? NEVER : nowNanos;
            serving = cell;
        }
        weakSince = NEVER;
        Arrays.fill(betterSince, NEVER);
    }
}
