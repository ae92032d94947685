package simgsm.center.msc.link;

import simgsm.air.Direction;
import simgsm.octets.OctetString;

/** Receives every signalling message that passes a link. */
public interface Trace {
    /** @param octets the layer 3 message, or the RSL message if there is none */
    void passed(Lifeline party, Direction direction, String name, OctetString octets);
}
