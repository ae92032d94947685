package simgsm.sms;

import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * One page of a broadcast message: 88 octets on the air (TS 23.041, 9.4.1).
 * <pre>
 *   serial(2) identifier(2) coding(1) page/pages(1) content(82)
 * </pre>
 *
 * @param messageIdentifier the channel, 0 to 65535
 * @param page 1 to {@code pages}
 * @param pages 1 to 15
 * @param content 82 octets: 93 septets or 41 two-octet characters, padded with carriage returns
 */
public record CellBroadcastPage(
        BroadcastSerial serial,
        int messageIdentifier,
        BroadcastCoding coding,
        int page,
        int pages,
        OctetString content) {
    public static final int LENGTH = 88;
    public static final int CONTENT_LENGTH = 82;
    public static final int MAX_PAGES = 15;

    public CellBroadcastPage {
        Bounds.check("broadcast channel", messageIdentifier, 0, 0xffff);
        if (pages < 1 || pages > MAX_PAGES || page < 1 || page > pages) {
            throw new IllegalArgumentException("page " + page + " of " + pages + " is not 1 to 15 of 1 to 15");
        }
        content.requireLength("a page's content", CONTENT_LENGTH);
    }

    /** The octets of the page. */
    public OctetString encode() {
        OctetWriter out = new OctetWriter();
        out.twoOctets(serial.value()).twoOctets(messageIdentifier);
        out.octet(coding.octet()).octet(page << 4 | pages).string(content);
        return out.toOctetString();
    }

    /** The page of these octets; a page number out of range is read as page 1 of 1 (9.4.1.2.4). */
    public static CellBroadcastPage decode(OctetString octets) throws ProtocolViolation {
        MessageReader in = new MessageReader(octets);
        if (octets.length() != LENGTH) {
            throw ProtocolViolation.invalid(
                    "a broadcast page of " + octets.length() + " octets, " + LENGTH + " were expected");
        }
        BroadcastSerial serial = BroadcastSerial.ofValue(in.twoOctets("serial number"));
        int messageIdentifier = in.twoOctets("message identifier");
        BroadcastCoding coding = new BroadcastCoding(in.octet("data coding scheme"));
        int numbers = in.octet("page parameter");
        int page = numbers >> 4;
        int pages = numbers & 0x0f;
        boolean isValid = page >= 1 && page <= pages;
        return new CellBroadcastPage(
                serial, messageIdentifier, coding, isValid ? page : 1, isValid ? pages : 1, in.rest());
    }
}
