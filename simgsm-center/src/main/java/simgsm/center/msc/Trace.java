package simgsm.center.msc;

import simgsm.air.Direction;
import simgsm.octets.OctetString;

/** Sees every signalling message that passes, for the ladder of the window. */
interface Trace {
    /** @param octets the layer-3 message, or the whole RSL message where there is no layer 3 */
    void passed(Link link, Direction direction, String name, OctetString octets);
}
