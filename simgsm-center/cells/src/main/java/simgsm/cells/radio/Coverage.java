package simgsm.cells.radio;

/**
 * A raster over the town: the strongest tower of each square and its level. Rows run from north to south, as in
 * pictures.
 *
 * @param best index of the strongest tower; {@link #NONE} if all are off
 * @param levelDbm its level
 * @param leadDecibels its advantage over the second; infinite if there is no second
 */
public record Coverage(int columns, int rows, short[] best, float[] levelDbm, float[] leadDecibels) {
    public static final short NONE = -1;
}
