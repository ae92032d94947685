package simgsm.cells.tower;

import simgsm.air.MobileIdentity;
import simgsm.octets.OctetString;

/** Receives a tower's messages to all mobiles of its cell. */
public interface TowerListener {
    /** PAGING REQUEST in the block of this group. */
    void paged(BaseStation tower, int group, MobileIdentity identity);

    /** A page of 88 octets of cell broadcast. */
    void broadcast(BaseStation tower, OctetString page);

    /** The controller refuses the tower for another reason than before. */
    void refused(TowerRefused refusal);

    /** System information, or the state of the link, has changed. */
    void changed(BaseStation tower);
}
