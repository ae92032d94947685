package simgsm.station;

import java.util.ArrayDeque;
import java.util.Deque;
import simgsm.octets.OctetString;

/**
 * Knows a message that the centre sends a second time because it never saw our acknowledgement: the same octets, so the
 * same originator, time stamp and part. A centre that does not keep the stamps of messages alike apart (ours does) may mean
 * two messages by them; so only what came over an earlier link, or was never confirmed, can come again.
 */
final class DuplicateFilter {
    private static final int MOST_REMEMBERED = 1000;
    /** Bit 2 of the first octet of DELIVER and STATUS-REPORT (TS 23.040, 9.2.3.2). */
    private static final byte MORE_MESSAGES_TO_SEND = 0x04;

    private final Deque<OctetString> mayComeAgain = new ArrayDeque<>();
    private final Deque<OctetString> ofThisLink = new ArrayDeque<>();

    /** Whether this is one that was received before; asking changes nothing. */
    boolean mayBeDuplicate(OctetString received) {
        return mayComeAgain.contains(withoutPrediction(received));
    }

    /** Asked once for each message received. */
    boolean isDuplicate(OctetString received) {
        OctetString tpdu = withoutPrediction(received);
        if (mayComeAgain.removeFirstOccurrence(tpdu)) {
            remember(ofThisLink, tpdu);
            return true;
        }
        remember(ofThisLink, tpdu);
        return false;
    }

    /** The network has not heard our acknowledgement of this message, received just now. */
    void unconfirmed(OctetString received) {
        OctetString tpdu = withoutPrediction(received);
        if (ofThisLink.removeLastOccurrence(tpdu)) {
            remember(mayComeAgain, tpdu);
        }
    }

    /** The centre may have forgotten what it had noted last. */
    void linkLost() {
        ofThisLink.forEach(tpdu -> remember(mayComeAgain, tpdu));
        ofThisLink.clear();
    }

    /** TP-MMS says whether more waits at the centre: that may have changed when the same message comes again. */
    private static OctetString withoutPrediction(OctetString tpdu) {
        byte[] octets = tpdu.toArray();
        if (octets.length > 0) {
            octets[0] |= MORE_MESSAGES_TO_SEND;
        }
        return OctetString.of(octets);
    }

    private static void remember(Deque<OctetString> memory, OctetString tpdu) {
        if (memory.size() == MOST_REMEMBERED) {
            memory.removeFirst();
        }
        memory.add(tpdu);
    }
}
