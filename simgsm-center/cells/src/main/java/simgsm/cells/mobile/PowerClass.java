package simgsm.cells.mobile;

import simgsm.air.Layer3Header;
import simgsm.octets.OctetString;
import simgsm.rr.Band;

/**
 * The RF power capability in the classmark of a connection's first message, which depends on the band (TS 24.008, 10.5.1.5
 * and 10.5.1.6): terminals name class 4 of GSM 900.
 */
final class PowerClass {
    private static final int CAPABILITY = 0x07;
    /** Class 1 of DCS 1800. */
    private static final int FIRST_CLASS = 0;

    private static final int MOBILITY_MANAGEMENT = 0x05;
    private static final int TYPE_MASK = 0x3f;
    private static final int PAGING_RESPONSE = 0x27;
    private static final int IMSI_DETACH = 0x01;
    private static final int LOCATION_UPDATING = 0x08;
    private static final int CM_SERVICE = 0x24;

    private PowerClass() {}

    /** The message with the capability for the band of a channel number. */
    static OctetString in(int arfcn, OctetString layer3) {
        int place = place(layer3);
        if (Band.of(arfcn) != Band.DCS_1800 || place < 0 || place >= layer3.length()) {
            return layer3;
        }
        byte[] octets = layer3.toArray();
        octets[place] = (byte) (octets[place] & ~CAPABILITY | FIRST_CLASS);
        return OctetString.of(octets);
    }

    /** The place of the classmark's first octet; -1 for a message without one. */
    private static int place(OctetString layer3) {
        if (layer3.length() < 2) {
            return -1;
        }
        int type = layer3.octet(1) & TYPE_MASK;
        if (layer3.octet(0) == Layer3Header.RADIO_RESOURCE) {
            return type == PAGING_RESPONSE ? 4 : -1;
        }
        if (layer3.octet(0) != MOBILITY_MANAGEMENT) {
            return -1;
        }
        return switch (type) {
            case IMSI_DETACH -> 2;
            case CM_SERVICE -> 4;
            case LOCATION_UPDATING -> 8;
            default -> -1;
        };
    }
}
