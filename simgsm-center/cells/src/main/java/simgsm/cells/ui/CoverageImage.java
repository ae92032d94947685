package simgsm.cells.ui;

import java.awt.image.BufferedImage;
import java.util.List;
import simgsm.cells.radio.Coverage;
import simgsm.cells.town.Tower;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;

/**
 * A coverage as a picture, one pixel per square: the colour is the strongest cell, its density the level in steps of 10
 * dB, so that the steps are contour lines. Borders and location areas omit shadowing, which would fragment them;
 * location areas other than the lowest are hatched.
 */
final class CoverageImage {
    /** Minimum level drawn; mobiles receive nothing below. */
    static final int WEAKEST_DBM = -110;

    static final int STEP_DECIBELS = 10;
    private static final int STEPS = 7;
    private static final double FAINTEST = 0.07;
    private static final double DENSER_EACH = 0.075;
    private static final double BAND_DENSER = 0.22;
    private static final double BORDER = 0.75;
    private static final double HATCH = 0.2;
    private static final int HATCH_SQUARES = 7;

    private final Coverage coverage;
    private final Coverage median;
    private final List<Tower> towers;
    private final Appearance appearance;
    private final int lowestArea;

    private CoverageImage(Coverage coverage, Coverage median, List<Tower> towers, Appearance appearance) {
        this.coverage = coverage;
        this.median = median;
        this.towers = towers;
        this.appearance = appearance;
        lowestArea = towers.stream().mapToInt(Tower::area).min().orElse(0);
    }

    /**
     * Draws the picture.
     *
     * @param median the coverage without shadowing, on the same raster
     * @param levels true to show levels
     * @param borders true to show borders
     * @param marginDecibels width of the strip along borders in which a mobile keeps its cell
     */
    static BufferedImage of(
            Coverage coverage,
            Coverage median,
            List<Tower> towers,
            Appearance appearance,
            boolean levels,
            boolean borders,
            double marginDecibels) {
        CoverageImage picture = new CoverageImage(coverage, median, towers, appearance);
        BufferedImage image = new BufferedImage(coverage.columns(), coverage.rows(), BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < coverage.rows(); row++) {
            for (int column = 0; column < coverage.columns(); column++) {
                image.setRGB(column, row, picture.color(column, row, levels, borders, marginDecibels));
            }
        }
        return image;
    }

    /** The density of a level's colour, 0 to 1. */
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
        int color = Ink.FLOOR.rgb(appearance);
        if (best != Coverage.NONE) {
            double density = levels ? density(coverage.levelDbm()[at]) : FAINTEST;
            color = blend(color, CellInk.of(best).rgb(appearance), density);
        }
        return borders ? bordered(color, column, row, marginDecibels) : color;
    }

    private int bordered(int color, int column, int row, double marginDecibels) {
        int at = row * median.columns() + column;
        int best = median.best()[at];
        if (best == Coverage.NONE || median.levelDbm()[at] < WEAKEST_DBM) {
            return color;
        }
        int result = color;
        if (median.leadDecibels()[at] < marginDecibels) {
            result = blend(result, CellInk.of(best).rgb(appearance), BAND_DENSER);
        }
        if (towers.get(best).area() != lowestArea && (column + row) % HATCH_SQUARES == 0) {
            result = blend(result, Ink.QUIET.rgb(appearance), HATCH);
        }
        return isBorder(column, row, best) ? blend(result, Ink.TEXT.rgb(appearance), BORDER) : result;
    }

    private boolean isBorder(int column, int row, int best) {
        return column + 1 < median.columns() && differs(row * median.columns() + column + 1, best)
                || row + 1 < median.rows() && differs((row + 1) * median.columns() + column, best);
    }

    private boolean differs(int at, int best) {
        return median.best()[at] != best && median.levelDbm()[at] >= WEAKEST_DBM;
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
