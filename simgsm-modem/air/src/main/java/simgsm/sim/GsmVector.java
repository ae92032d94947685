package simgsm.sim;

import simgsm.octets.OctetString;
import simgsm.octets.Octets;

/**
 * The GSM authentication vector of a challenge.
 *
 * @param sres the card's answer, 4 octets
 * @param kc the ciphering key, 8 octets
 */
public record GsmVector(OctetString sres, OctetString kc) {
    public static final int SRES_LENGTH = 4;
    public static final int KC_LENGTH = 8;

    /** The UMTS values of a challenge, by the conversion functions c2 and c3 (TS 33.102, 6.8.1.2). */
    public static GsmVector of(Milenage functions, OctetString rand) {
        byte[] res = functions.f2(rand).toArray();
        byte[] ck = functions.f3(rand).toArray();
        byte[] ik = functions.f4(rand).toArray();
        return new GsmVector(
                OctetString.of(folded(res, SRES_LENGTH)),
                OctetString.of(Milenage.xor(folded(ck, KC_LENGTH), folded(ik, KC_LENGTH))));
    }

    /** The exclusive or of all pieces of this length. */
    private static byte[] folded(byte[] octets, int length) {
        byte[] result = new byte[length];
        for (int from = 0; from < octets.length; from += length) {
            result = Milenage.xor(result, Octets.range(octets, from, from + length));
        }
        return result;
    }
}
