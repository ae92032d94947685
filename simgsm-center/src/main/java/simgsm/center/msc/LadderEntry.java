package simgsm.center.msc;

import java.time.Instant;
import simgsm.octets.OctetString;

/**
 * One signalling message of the ladder diagram.
 *
 * @param from a number, {@link #CENTER}, a tower, or what is known of a terminal that has not registered
 * @param to as {@code from}
 * @param name the message's name in the standard
 * @param isCiphered true if it is ciphered on the air
 * @param octets the layer 3 message; for paging, cell broadcast and towers the RSL message
 */
public record LadderEntry(Instant time, String from, String to, String name, boolean isCiphered, OctetString octets) {
    /** The lifeline of the centre. */
    public static final String CENTER = "M3";

    /** A message in the clear. */
    public LadderEntry(Instant time, String from, String to, String name, OctetString octets) {
        this(time, from, to, name, false, octets);
    }
}
