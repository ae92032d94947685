package simgsm.sim;

import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;

/**
 * A SIM: the data shared by a subscriber's card and the network's authentication centre.
 *
 * @param number the subscriber's telephone number; the network's entry is authoritative
 * @param k the secret key, 16 octets
 * @param opc the operator's value for this key, 16 octets
 */
public record SimCard(Imsi imsi, Msisdn number, OctetString k, OctetString opc) {
    public SimCard {
        k.requireLength("K", Milenage.KEY_LENGTH);
        opc.requireLength("OPc", Milenage.KEY_LENGTH);
    }

    /** The authentication functions with this card's keys. */
    public Milenage functions() {
        return new Milenage(k, opc);
    }

    /** Without the keys, because logs may contain it. */
    @Override
    public String toString() {
        return "SIM of " + number + ", IMSI " + imsi;
    }
}
