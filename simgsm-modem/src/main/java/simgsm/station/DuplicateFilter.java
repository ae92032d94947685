package simgsm.station;

import java.util.ArrayDeque;
import java.util.Deque;
import simgsm.air.OctetString;

/**
 * Knows a message that the centre sends a second time because it never saw our acknowledgement: the same octets, so the
 * same originator, time stamp and part. Two messages that were written alike within a second are not that; so only what
 * came over an earlier link, or was never confirmed, can come again.
 */
final class DuplicateFilter {
    private static final int MOST_REMEMBERED = 1000;

    private final Deque<OctetString> mayComeAgain = new ArrayDeque<>();
    private final Deque<OctetString> ofThisLink = new ArrayDeque<>();

    /** Asked once for each message received. */
    boolean isDuplicate(OctetString tpdu) {
        if (mayComeAgain.removeFirstOccurrence(tpdu)) {
            remember(ofThisLink, tpdu);
            return true;
        }
        remember(ofThisLink, tpdu);
        return false;
    }

    /** The network has not heard our acknowledgement of this message, received just now. */
    void unconfirmed(OctetString tpdu) {
        if (ofThisLink.removeLastOccurrence(tpdu)) {
            remember(mayComeAgain, tpdu);
        }
    }

    /** The centre may have forgotten what it had noted last. */
    void linkLost() {
        ofThisLink.forEach(tpdu -> remember(mayComeAgain, tpdu));
        ofThisLink.clear();
    }

    private static void remember(Deque<OctetString> memory, OctetString tpdu) {
        if (memory.size() == MOST_REMEMBERED) {
            memory.removeFirst();
        }
        memory.add(tpdu);
    }
}
