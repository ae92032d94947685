package simgsm.center.bsc.handover;

/**
 * A neighbour cell in a mobile's report.
 *
 * @param frequency ARFCN
 * @param identityCode BSIC
 */
public record NeighbourCell(int frequency, int identityCode) {}
