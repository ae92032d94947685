package simgsm.cells.mobile;

import java.util.Set;
import simgsm.air.CipherAlgorithm;
import simgsm.air.Layer3Header;
import simgsm.octets.OctetString;

/**
 * The ciphering algorithms in a terminal's classmark (TS 24.008, 10.5.1.5 and 10.5.1.6): those that its radio part, which
 * is here, does not have are taken out.
 */
final class RadioClassmark {
    /** In the first octet: A5/1 is not available. */
    private static final int NO_A5_1 = 0x08;
    /** In the third octet of classmark 2: A5/3 is available. */
    private static final int A5_3 = 0x02;

    private RadioClassmark() {}

    /** The message with the classmark of a radio that has these algorithms. */
    static OctetString in(OctetString layer3, Set<CipherAlgorithm> algorithms) {
        byte[] octets = layer3.toArray();
        int at = octets.length < 2 ? 0 : place(octets[0], octets[1]);
        boolean isClassmark2 = at > 0 && at + 2 < octets.length && octets[at - 1] == 3;
        if (at == 0 || at >= octets.length) {
            return layer3;
        }
        if (!algorithms.contains(CipherAlgorithm.A5_1)) {
            octets[at] |= NO_A5_1;
        }
        if (isClassmark2 && !algorithms.contains(CipherAlgorithm.A5_3)) {
            octets[at + 2] &= ~A5_3;
        }
        return OctetString.of(octets);
    }

    /** Index of the first octet of the classmark; 0 for a message without one. */
    private static int place(int discriminator, int type) {
        if (discriminator == Layer3Header.RADIO_RESOURCE) {
            return type == 0x27 ? 4 : type == 0x16 ? 3 : 0;
        }
        return discriminator != Layer3Header.MOBILITY_MANAGEMENT
                ? 0
                : switch (type & 0x3f) {
                    case 0x01 -> 2;
                    case 0x08 -> 8;
                    case 0x24 -> 4;
                    default -> 0;
                };
    }
}
