package simgsm.station.mobility;

import java.util.Optional;
import simgsm.air.RejectCause;
import simgsm.octets.OctetString;
import simgsm.octets.Octets;
import simgsm.sim.GsmVector;
import simgsm.sim.Milenage;
import simgsm.sim.PinLock;
import simgsm.sim.SimCard;

/**
 * A SIM with a key. It answers every GSM challenge. With Milenage it answers a challenge with AUTN only if the MAC is
 * right and SQN is higher than all before (TS 33.102, 6.3.3); other cards are no USIM, and AUTN is ignored.
 */
final class KeyedSim implements Sim {
    /** AMF in the MAC-S of a resynchronisation (TS 33.102, 6.3.3). */
    private static final OctetString RESYNCHRONISATION_AMF = OctetString.ofHex("0000");

    private final SimCard card;
    private final PinLock lock;
    /** Null without Milenage. */
    private final Milenage functions;
    /** The highest SQN so far, at first 0. */
    private long sequence;

    KeyedSim(SimCard card, PinLock lock) {
        this.card = card;
        this.lock = lock;
        functions = card.functions().orElse(null);
    }

    @Override
    public PinLock lock() {
        return lock;
    }

    @Override
    public AuthenticationResult authenticate(OctetString rand, Optional<OctetString> autn) {
        GsmVector vector = card.vector(rand);
        return autn.isPresent() && functions != null
                ? answer(rand, autn.get().toArray(), vector.kc())
                : AuthenticationResult.response(vector.sres(), vector.kc());
    }

    /** AUTN: SQN xor AK (6 octets), AMF (2), MAC-A (8). */
    private AuthenticationResult answer(OctetString rand, byte[] autn, OctetString kc) {
        long sqn = xor(autn, functions.f5(rand));
        OctetString amf = part(autn, Milenage.SEQUENCE_LENGTH, Milenage.MANAGEMENT_LENGTH);
        int macAt = Milenage.SEQUENCE_LENGTH + Milenage.MANAGEMENT_LENGTH;
        if (!functions.f1(rand, octets(sqn), amf).equals(part(autn, macAt, autn.length - macAt))) {
            return AuthenticationResult.failure(RejectCause.MAC_FAILURE, Optional.empty());
        }
        if (sqn <= sequence) {
            return AuthenticationResult.failure(RejectCause.SYNCH_FAILURE, Optional.of(resynchronisation(rand)));
        }
        sequence = sqn;
        return AuthenticationResult.response(functions.f2(rand), kc);
    }

    /** AUTS: the highest SQN xor AK* (6 octets), MAC-S (8). */
    private OctetString resynchronisation(OctetString rand) {
        OctetString concealed = octets(xor(octets(sequence).toArray(), functions.f5Star(rand)));
        return OctetString.ofHex("" + concealed + functions.f1Star(rand, octets(sequence), RESYNCHRONISATION_AMF));
    }

    private static long xor(byte[] sqn, OctetString key) {
        byte[] mask = key.toArray();
        long number = 0;
        for (int i = 0; i < mask.length; i++) {
            number = number << Byte.SIZE | (sqn[i] ^ mask[i]) & 0xff;
        }
        return number;
    }

    private static OctetString octets(long number) {
        return OctetString.ofHex(String.format("%012x", number));
    }

    private static OctetString part(byte[] octets, int from, int length) {
        return OctetString.of(Octets.range(octets, from, from + length));
    }
}
