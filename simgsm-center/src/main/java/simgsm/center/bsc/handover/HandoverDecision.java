package simgsm.center.bsc.handover;

import java.util.Optional;

/** Decides for one mobile on one traffic channel. Each channel has a new decision. */
public interface HandoverDecision {
    /** A cell to move to. */
    record Target(NeighbourCell cell, Reason reason) {}

    /** Reason of a handover. */
    enum Reason {
        /** Bad quality in spite of a good level. */
        INTERFERENCE,
        BAD_QUALITY,
        LOW_LEVEL,
        DISTANCE,
        /** Another cell is better. */
        POWER_BUDGET
    }

    /** Adds a result, even if no handover is possible. */
    void add(Measurement measurement);

    /** The target after the latest result, if any. */
    Optional<Target> target();
}
