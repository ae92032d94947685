package simgsm.cells.mobile;

import java.util.Set;
import simgsm.air.CipherAlgorithm;
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

    /** N(SD); messages of radio resources have none. */
    private static final int SEND_SEQUENCE = 0x40;

    private RadioClassmark() {}

    /** The message with the classmark of a radio that has these algorithms. */
    static OctetString in(OctetString layer3, Set<CipherAlgorithm> algorithms) {
        byte[] octets = layer3.toArray();
        int at = octets.length < 2 ? 0 : place(octets[0] << Byte.SIZE | octets[1] & 0xff);
        if (at == 0 || at >= octets.length) {
            return layer3;
        }
        if (!algorithms.contains(CipherAlgorithm.A5_1)) {
            octets[at] |= NO_A5_1;
        }
        boolean isClassmark2 = at + 2 < octets.length && octets[at - 1] == 3;
        if (isClassmark2 && !algorithms.contains(CipherAlgorithm.A5_3)) {
            octets[at + 2] &= ~A5_3;
        }
        return OctetString.of(octets);
    }

    /** Index of the first octet of the classmark, by discriminator and type without N(SD); 0 for a message without one. */
    private static int place(int type) {
        return switch (type & ~SEND_SEQUENCE) {
            case 0x0501 -> 2;
            case 0x0508 -> 8;
            case 0x0524, 0x0627 -> 4;
            case 0x0616 -> 3;
            default -> 0;
        };
    }
}
