package simgsm.cells.radio;

import java.util.Arrays;
import java.util.List;
import simgsm.cells.town.Town;

/**
 * The losses of all towers on a raster over the town. They dominate the computing time and do not depend on the towers'
 * power, so a change of power needs only {@link #coverage}. Immutable.
 */
public final class LossRaster {
    private final int columns;
    private final int rows;
    /** Losses by tower, then row by row from the north. */
    private final float[][] losses;

    private LossRaster(int columns, int rows, float[][] losses) {
        this.columns = columns;
        this.rows = rows;
        this.losses = losses;
    }

    /** Computes the raster at the middle of each square. */
    public static LossRaster of(Propagation propagation, double squareMetres) {
        Town town = propagation.town();
        int columns = (int) Math.max(1, Math.ceil(town.widthMetres() / squareMetres));
        int rows = (int) Math.max(1, Math.ceil(town.heightMetres() / squareMetres));
        int towers = town.towers().size();
        float[][] losses = new float[towers][columns * rows];
        double[] here = new double[towers];
        for (int row = 0; row < rows; row++) {
            double y = town.southMetres() + town.heightMetres() - (row + 0.5) * squareMetres;
            for (int column = 0; column < columns; column++) {
                propagation.lossesDecibels(town.westMetres() + (column + 0.5) * squareMetres, y, here);
                for (int i = 0; i < towers; i++) {
                    losses[i][row * columns + column] = (float) here[i];
                }
            }
        }
        return new LossRaster(columns, rows, losses);
    }

    /**
     * The coverage.
     *
     * @param towers current states, in the order of the town
     */
    public Coverage coverage(List<TowerState> towers) {
        int squares = columns * rows;
        short[] best = new short[squares];
        float[] level = new float[squares];
        float[] second = new float[squares];
        Arrays.fill(best, Coverage.NONE);
        Arrays.fill(level, Float.NEGATIVE_INFINITY);
        Arrays.fill(second, Float.NEGATIVE_INFINITY);
        for (int i = 0; i < losses.length; i++) {
            if (towers.get(i).isOn()) {
                float power = (float) towers.get(i).powerDbm();
                for (int k = 0; k < squares; k++) {
                    float dbm = power - losses[i][k];
                    if (dbm > level[k]) {
                        second[k] = level[k];
                        level[k] = dbm;
                        best[k] = (short) i;
                    } else if (dbm > second[k]) {
                        second[k] = dbm;
                    }
                }
            }
        }
        for (int k = 0; k < squares; k++) {
            second[k] = level[k] - second[k];
        }
        return new Coverage(columns, rows, best, level, second);
    }
}
