package simgsm.center.msc.link;

import simgsm.octets.OctetString;

/** Transmits cell broadcast to one terminal, or to all mobiles of a controller's towers. */
public interface BroadcastChannel {
    /** @param page of 88 octets (TS 23.041) */
    void broadcast(OctetString page);
}
