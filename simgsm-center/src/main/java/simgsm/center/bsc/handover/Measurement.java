package simgsm.center.bsc.handover;

import java.util.List;

/**
 * One measurement result of a mobile on a traffic channel. Levels are RXLEV, 0 to 63: the level in dBm plus 110.
 *
 * @param number 0 to 255, counts the results of a channel
 * @param isValid true if the values of the serving cell are valid
 * @param level of the serving cell over all bursts
 * @param averagedLevel of the serving cell, over the bursts certainly sent, and without the base station's power
 * reduction
 * @param quality RXQUAL, 0 to 7, over the same bursts
 * @param timingAdvance in bits
 * @param neighbours at most 6, in the order of the report
 */
public record Measurement(
        int number,
        boolean isValid,
        int level,
        int averagedLevel,
        int quality,
        int timingAdvance,
        List<Neighbour> neighbours) {
    /** RXLEV minus the level in dBm. */
    public static final int RXLEV_OFFSET = 110;

    /** A neighbour cell with its level. */
    public record Neighbour(NeighbourCell cell, int level) {}

    public Measurement {
        neighbours = List.copyOf(neighbours);
    }
}
