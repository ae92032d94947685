package simgsm.sim;

import java.util.Optional;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;

/**
 * A SIM: the data shared by a subscriber's card and the network's authentication centre, and the card's PIN.
 *
 * @param number the subscriber's telephone number; the network's entry is authoritative
 * @param k the secret key, 16 octets
 * @param opc the operator's value for this key, 16 octets; with Milenage only
 * @param pin empty for a card that never asks for one
 */
public record SimCard(
        Imsi imsi,
        Msisdn number,
        OctetString k,
        CardAlgorithm algorithm,
        Optional<OctetString> opc,
        Optional<CardPin> pin) {
    public SimCard {
        k.requireLength("K", Milenage.KEY_LENGTH);
        opc.ifPresent(value -> value.requireLength("OPc", Milenage.KEY_LENGTH));
        if (opc.isPresent() != (algorithm == CardAlgorithm.MILENAGE)) {
            throw new IllegalArgumentException("expected an OPc with Milenage only");
        }
    }

    /** A card with Milenage and without a PIN. */
    public SimCard(Imsi imsi, Msisdn number, OctetString k, OctetString opc) {
        this(imsi, number, k, CardAlgorithm.MILENAGE, Optional.of(opc), Optional.empty());
    }

    /** The authentication functions of UMTS with this card's keys; empty for a card without Milenage. */
    public Optional<Milenage> functions() {
        return opc.map(value -> new Milenage(k, value));
    }

    /** The GSM authentication vector of a challenge. @param rand 16 octets */
    public GsmVector vector(OctetString rand) {
        return algorithm.vector(this, rand);
    }

    /** Without the keys, because logs may contain it. */
    @Override
    public String toString() {
        return "SIM of " + number + ", IMSI " + imsi;
    }
}
