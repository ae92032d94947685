package simgsm.cells.tower;

import simgsm.air.MobileIdentity;
import simgsm.octets.OctetString;

/** What a tower sends to all mobiles of its cell. */
public interface TowerListener {
    /** PAGING REQUEST in the block of this group. */
    void paged(BaseStation tower, int group, MobileIdentity identity);

    /** A page of 88 octets of cell broadcast. */
    void broadcast(BaseStation tower, OctetString page);

    /** System information has arrived or the link has come or gone. */
    void changed(BaseStation tower);
}
