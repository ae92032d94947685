package simgsm.center.msc;

import java.time.Instant;
import simgsm.octets.OctetString;

/**
 * One signalling message on its way, a rung of the ladder.
 *
 * @param from a number, {@link #CENTER}, or the address of a terminal that has not yet registered
 * @param to likewise
 * @param name the standard's name of the message
 * @param octets the layer-3 message; for paging and cell broadcast the RSL message
 */
public record LadderEntry(Instant time, String from, String to, String name, OctetString octets) {
    /** The centre's own lifeline. */
    public static final String CENTER = "M3";
}
