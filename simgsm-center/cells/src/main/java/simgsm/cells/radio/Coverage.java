package simgsm.cells.radio;

import java.util.List;
import simgsm.cells.town.Town;

/**
 * A raster over the town: the strongest tower of each square and its level. Rows run from north to south, as pictures have
 * them.
 *
 * @param best index of the strongest tower; -1 where all are off
 * @param levelDbm its level
 */
public record Coverage(int columns, int rows, double squareMetres, short[] best, float[] levelDbm) {

    /**
     * Computes the raster; a square is represented by its middle.
     *
     * @param towers as they are now, in the order of the town
     */
    public static Coverage of(Propagation propagation, List<TowerState> towers, double squareMetres) {
        Town town = propagation.town();
        int columns = (int) Math.max(1, Math.ceil(town.widthMetres() / squareMetres));
        int rows = (int) Math.max(1, Math.ceil(town.heightMetres() / squareMetres));
        short[] best = new short[columns * rows];
        float[] level = new float[columns * rows];
        double[] losses = new double[towers.size()];
        for (int row = 0; row < rows; row++) {
            double y = town.southMetres() + town.heightMetres() - (row + 0.5) * squareMetres;
            for (int column = 0; column < columns; column++) {
                propagation.lossesDecibels(town.westMetres() + (column + 0.5) * squareMetres, y, losses);
                int strongest = -1;
                double most = RadioField.SILENCE_DBM;
                for (int i = 0; i < losses.length; i++) {
                    TowerState tower = towers.get(i);
                    if (tower.isOn() && tower.powerDbm() - losses[i] > most) {
                        strongest = i;
                        most = tower.powerDbm() - losses[i];
                    }
                }
                best[row * columns + column] = (short) strongest;
                level[row * columns + column] = (float) most;
            }
        }
        return new Coverage(columns, rows, squareMetres, best, level);
    }
}
