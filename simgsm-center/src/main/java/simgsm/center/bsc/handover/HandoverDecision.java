package simgsm.center.bsc.handover;

import java.util.Optional;

/** Decides for one mobile on one traffic channel. A new channel begins with a new decision. */
public interface HandoverDecision {
    /** A cell to move to. */
    record Target(NeighbourCell cell, Reason reason) {}

    /** Why a mobile is to move. */
    enum Reason {
        /** Bad quality in spite of a good level. */
        INTERFERENCE,
        BAD_QUALITY,
        LOW_LEVEL,
        DISTANCE,
        /** Another cell is better. */
        POWER_BUDGET
    }

    /** Takes each result, also while no handover is possible. */
    void add(Measurement measurement);

    /** The cell to move to after the latest result, if any. */
    Optional<Target> target();
}
