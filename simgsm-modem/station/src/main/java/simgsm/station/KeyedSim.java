package simgsm.station;

import java.util.Arrays;
import java.util.Optional;
import simgsm.air.RejectCause;
import simgsm.octets.OctetString;
import simgsm.sim.GsmVector;
import simgsm.sim.Milenage;
import simgsm.sim.SimCard;

/**
 * A card that knows its key. A GSM challenge it always answers; a challenge with AUTN only if that comes from its own
 * network and is newer than all before (TS 33.102, 6.3.3).
 */
final class KeyedSim implements Sim {
    /** What a network has to write into a resynchronisation's MAC-S (TS 33.102, 6.3.3). */
    private static final OctetString NO_MANAGEMENT = OctetString.ofHex("0000");

    private final Milenage functions;
    /** Highest number of a challenge so far; a card begins with 0. */
    private long sequence;

    KeyedSim(SimCard card) {
        functions = card.functions();
    }

    @Override
    public Answer authenticate(OctetString rand, Optional<OctetString> autn) {
        return autn.isPresent()
                ? answer(rand, autn.get().toArray())
                : Answer.response(GsmVector.of(functions, rand).sres());
    }

    /** AUTN is SQN, hidden by AK, then AMF, then MAC-A. */
    private Answer answer(OctetString rand, byte[] autn) {
        long number = hidden(autn, functions.f5(rand));
        OctetString amf = part(autn, Milenage.SEQUENCE_LENGTH, Milenage.MANAGEMENT_LENGTH);
        int macAt = Milenage.SEQUENCE_LENGTH + Milenage.MANAGEMENT_LENGTH;
        if (!functions.f1(rand, octets(number), amf).equals(part(autn, macAt, autn.length - macAt))) {
            return Answer.failure(RejectCause.MAC_FAILURE, Optional.empty());
        }
        if (number <= sequence) {
            return Answer.failure(RejectCause.SYNCH_FAILURE, Optional.of(resynchronisation(rand)));
        }
        sequence = number;
        return Answer.response(functions.f2(rand));
    }

    /** AUTS: the highest number so far, hidden, and MAC-S over it. */
    private OctetString resynchronisation(OctetString rand) {
        OctetString hidden = octets(hidden(octets(sequence).toArray(), functions.f5Star(rand)));
        return OctetString.ofHex("" + hidden + functions.f1Star(rand, octets(sequence), NO_MANAGEMENT));
    }

    private static long hidden(byte[] sqn, OctetString key) {
        byte[] cover = key.toArray();
        long number = 0;
        for (int i = 0; i < cover.length; i++) {
            number = number << Byte.SIZE | (sqn[i] ^ cover[i]) & 0xff;
        }
        return number;
    }

    private static OctetString octets(long number) {
        return OctetString.ofHex(String.format("%012x", number));
    }

    private static OctetString part(byte[] octets, int from, int length) {
        return OctetString.of(Arrays.copyOfRange(octets, from, from + length));
    }
}
