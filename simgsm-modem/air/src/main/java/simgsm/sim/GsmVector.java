package simgsm.sim;

import java.util.Arrays;
import simgsm.octets.OctetString;

/**
 * What a GSM network needs of a challenge, made from the third generation's values by the conversion functions c2 and c3
 * (TS 33.102, 6.8.1.2).
 *
 * @param sres the card's answer, 4 octets
 * @param kc the ciphering key, 8 octets; derived and never used, since nothing is ciphered here
 */
public record GsmVector(OctetString sres, OctetString kc) {
    public static final int SRES_LENGTH = 4;
    public static final int KC_LENGTH = 8;

    public static GsmVector of(Milenage functions, OctetString rand) {
        byte[] res = functions.f2(rand).toArray();
        byte[] ck = functions.f3(rand).toArray();
        byte[] ik = functions.f4(rand).toArray();
        return new GsmVector(
                OctetString.of(folded(res, SRES_LENGTH)),
                OctetString.of(Milenage.xor(folded(ck, KC_LENGTH), folded(ik, KC_LENGTH))));
    }

    /** All pieces of this length, one upon the other. */
    private static byte[] folded(byte[] octets, int length) {
        byte[] result = new byte[length];
        for (int from = 0; from < octets.length; from += length) {
            result = Milenage.xor(result, Arrays.copyOfRange(octets, from, from + length));
        }
        return result;
    }
}
