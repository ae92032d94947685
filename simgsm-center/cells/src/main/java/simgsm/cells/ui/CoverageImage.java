package simgsm.cells.ui;

import java.awt.image.BufferedImage;
import java.util.List;
import simgsm.cells.radio.Coverage;
import simgsm.cells.town.Tower;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;

/**
 * A coverage as a picture, a pixel a square: the colour is the strongest cell, its density the level in steps of 10 dB, so
 * that the steps are contour lines. Location areas other than the lowest are hatched.
 */
final class CoverageImage {
    /** Nothing is drawn below; mobiles hear nothing there. */
    static final int WEAKEST_DBM = -110;

    static final int STEP_DECIBELS = 10;
    private static final int STEPS = 7;
    private static final double FAINTEST = 0.07;
    private static final double DENSER_EACH = 0.075;
    private static final double BAND_DENSER = 0.12;
    private static final double BORDER = 0.75;
    private static final double HATCH = 0.2;
    private static final int HATCH_SQUARES = 7;

    private final Coverage coverage;
    private final List<Tower> towers;
    private final Appearance appearance;
    private final int lowestArea;

    private CoverageImage(Coverage coverage, List<Tower> towers, Appearance appearance) {
        this.coverage = coverage;
        this.towers = towers;
        this.appearance = appearance;
        lowestArea = towers.stream().mapToInt(Tower::area).min().orElse(0);
    }

    /**
     * Draws the picture.
     *
     * @param levels whether levels are shown
     * @param borders whether borders are shown
     * @param marginDecibels width of the strip along borders in which a mobile keeps the cell that it has
     */
    static BufferedImage of(
            Coverage coverage,
            List<Tower> towers,
            Appearance appearance,
            boolean levels,
            boolean borders,
            double marginDecibels) {
        CoverageImage picture = new CoverageImage(coverage, towers, appearance);
        BufferedImage image = new BufferedImage(coverage.columns(), coverage.rows(), BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < coverage.rows(); row++) {
            for (int column = 0; column < coverage.columns(); column++) {
                image.setRGB(column, row, picture.color(column, row, levels, borders, marginDecibels));
            }
        }
        return image;
    }

    /** How dense a level is drawn, 0 to 1. */
    static double density(double dbm) {
        if (dbm < WEAKEST_DBM) {
            return 0;
        }
        int step = Math.min(STEPS - 1, (int) ((dbm - WEAKEST_DBM) / STEP_DECIBELS));
        return FAINTEST + step * DENSER_EACH;
    }

    private int color(int column, int row, boolean levels, boolean borders, double marginDecibels) {
        int at = row * coverage.columns() + column;
        int best = coverage.best()[at];
        int floor = Ink.FLOOR.rgb(appearance);
        if (best == Coverage.NONE || coverage.levelDbm()[at] < WEAKEST_DBM) {
            return floor;
        }
        double density = levels ? density(coverage.levelDbm()[at]) : FAINTEST;
        if (borders && coverage.leadDecibels()[at] < marginDecibels) {
            density += BAND_DENSER;
        }
        int color = blend(floor, CellInk.of(best).rgb(appearance), density);
        if (borders && towers.get(best).area() != lowestArea && (column + row) % HATCH_SQUARES == 0) {
            color = blend(color, Ink.QUIET.rgb(appearance), HATCH);
        }
        return borders && isBorder(column, row, best) ? blend(color, Ink.TEXT.rgb(appearance), BORDER) : color;
    }

    private boolean isBorder(int column, int row, int best) {
        return column + 1 < coverage.columns() && differs(row * coverage.columns() + column + 1, best)
                || row + 1 < coverage.rows() && differs((row + 1) * coverage.columns() + column, best);
    }

    private boolean differs(int at, int best) {
        return coverage.best()[at] != best && coverage.levelDbm()[at] >= WEAKEST_DBM;
    }

    private static int blend(int under, int over, double share) {
        int color = 0;
        for (int shift = 0; shift <= 16; shift += 8) {
            double part = (under >> shift & 0xff) * (1 - share) + (over >> shift & 0xff) * share;
            color |= (int) Math.round(part) << shift;
        }
        return color;
    }
}
