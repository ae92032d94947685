package simgsm.center.bsc.handover;

/** A neighbour cell as a mobile reports it. @param frequency ARFCN @param identityCode BSIC */
public record NeighbourCell(int frequency, int identityCode) {}
