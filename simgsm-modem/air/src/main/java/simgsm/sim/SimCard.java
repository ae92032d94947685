package simgsm.sim;

import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;

/**
 * What a subscriber's card and the network's authentication centre share.
 *
 * @param number the subscriber's telephone number; on a card a convenience, in the network the truth
 * @param k the secret key, 16 octets
 * @param opc the operator's value for this key, 16 octets
 */
public record SimCard(Imsi imsi, Msisdn number, OctetString k, OctetString opc) {
    public SimCard {
        requireKey("K", k);
        requireKey("OPc", opc);
    }

    private static void requireKey(String what, OctetString key) {
        if (key.length() != Milenage.KEY_LENGTH) {
            throw new IllegalArgumentException(
                    what + " has " + key.length() + " octets, " + Milenage.KEY_LENGTH + " were expected");
        }
    }

    public Milenage functions() {
        return new Milenage(k, opc);
    }

    /** Without the keys: this may stand in a log. */
    @Override
    public String toString() {
        return "SIM of " + number + ", IMSI " + imsi;
    }
}
