package simgsm.station.sms;

import java.util.ArrayDeque;
import java.util.Deque;
import simgsm.octets.OctetString;

/**
 * Recognises a message that the centre delivers again because the acknowledgement was lost: the same octets, so the
 * same originator, time stamp and part. Other centres may give two messages the same time stamp; therefore only a
 * message from an earlier link, or one with an unconfirmed acknowledgement, can have a duplicate.
 */
final class DuplicateFilter {
    private static final int MAX_REMEMBERED = 1000;
    /** Bit 2 of the first octet of DELIVER and STATUS-REPORT (TS 23.040, 9.2.3.2). */
    private static final byte MORE_MESSAGES_TO_SEND = 0x04;

    private final Deque<OctetString> repeatable = new ArrayDeque<>();
    private final Deque<OctetString> confirmed = new ArrayDeque<>();

    /** True if a message with these octets may be a duplicate; changes nothing. */
    boolean mayBeDuplicate(OctetString received) {
        return repeatable.contains(withoutMoreMessages(received));
    }

    /** True if the message is a duplicate; called once for each message received. */
    boolean isDuplicate(OctetString received) {
        OctetString tpdu = withoutMoreMessages(received);
        if (repeatable.removeFirstOccurrence(tpdu)) {
            remember(confirmed, tpdu);
            return true;
        }
        remember(confirmed, tpdu);
        return false;
    }

    /** The network may not have received the acknowledgement of this message, the newest. */
    void unconfirmed(OctetString received) {
        OctetString tpdu = withoutMoreMessages(received);
        if (confirmed.removeLastOccurrence(tpdu)) {
            remember(repeatable, tpdu);
        }
    }

    /** The message was not taken: it comes again. @param tpdu as of {@link #withoutMoreMessages} */
    void forget(OctetString tpdu) {
        confirmed.removeLastOccurrence(tpdu);
        repeatable.removeLastOccurrence(tpdu);
    }

    /** The centre may have lost acknowledgements of the last link. */
    void linkLost() {
        confirmed.forEach(tpdu -> remember(repeatable, tpdu));
        confirmed.clear();
    }

    /** Without TP-MMS, which may differ in the second delivery. */
    static OctetString withoutMoreMessages(OctetString tpdu) {
        byte[] octets = tpdu.toArray();
        if (octets.length > 0) {
            octets[0] |= MORE_MESSAGES_TO_SEND;
        }
        return OctetString.of(octets);
    }

    private static void remember(Deque<OctetString> messages, OctetString tpdu) {
        if (messages.size() == MAX_REMEMBERED) {
            messages.removeFirst();
        }
        messages.add(tpdu);
    }
}
