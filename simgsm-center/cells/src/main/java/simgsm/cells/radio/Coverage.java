package simgsm.cells.radio;

/**
 * A raster over the town: the strongest tower of each square and its level. Rows run from north to south, as pictures have
 * them.
 *
 * @param best index of the strongest tower; {@link #NONE} where all are off
 * @param levelDbm its level
 * @param leadDecibels by which it exceeds the second; infinite where there is no second
 */
public record Coverage(int columns, int rows, short[] best, float[] levelDbm, float[] leadDecibels) {
    public static final short NONE = -1;
}
