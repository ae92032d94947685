package simgsm.station;

import java.util.Optional;
import simgsm.air.RejectCause;
import simgsm.octets.OctetString;
import simgsm.sim.SimCard;

/** The card's answer to the network's challenge (TS 24.008, 4.3.2). */
@FunctionalInterface
public interface Sim {
    /** A card without a key: it cannot prove anything. */
    Sim WITHOUT_KEY = (rand, autn) -> Answer.failure(RejectCause.MAC_FAILURE, Optional.empty());

    /** A card with a key. */
    static Sim of(SimCard card) {
        return new KeyedSim(card);
    }

    /**
     * @param rand 16 octets
     * @param autn 16 octets for a USIM's challenge, empty for a SIM's
     */
    Answer authenticate(OctetString rand, Optional<OctetString> autn);

    /**
     * One of: a response, or the cause why there is none.
     *
     * @param response SRES or RES, 4 to 16 octets
     * @param failure MAC_FAILURE or SYNCH_FAILURE
     * @param auts resynchronisation token, 14 octets, with SYNCH_FAILURE only
     */
    record Answer(Optional<OctetString> response, Optional<RejectCause> failure, Optional<OctetString> auts) {
        public Answer {
            if (response.isPresent() == failure.isPresent()) {
                throw new IllegalArgumentException("an answer is either a response or a failure");
            }
        }

        public static Answer response(OctetString response) {
            return new Answer(Optional.of(response), Optional.empty(), Optional.empty());
        }

        public static Answer failure(RejectCause cause, Optional<OctetString> auts) {
            return new Answer(Optional.empty(), Optional.of(cause), auts);
        }
    }
}
