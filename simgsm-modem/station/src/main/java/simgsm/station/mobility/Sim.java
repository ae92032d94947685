package simgsm.station.mobility;

import java.util.Optional;
import simgsm.air.RejectCause;
import simgsm.octets.OctetString;
import simgsm.sim.InsertedCard;
import simgsm.sim.PinLock;
import simgsm.sim.SimCard;

/** Answers the network's challenges (TS 24.008, 4.3.2). */
@FunctionalInterface
public interface Sim {
    /** The lock of a card without a PIN. */
    PinLock OPEN = PinLock.none();

    /** A SIM without a key: every authentication fails. */
    Sim WITHOUT_KEY = (rand, autn) -> AuthenticationResult.failure(RejectCause.MAC_FAILURE, Optional.empty());

    /** A SIM with a key and without a PIN. */
    static Sim of(SimCard card) {
        return of(new InsertedCard(card, OPEN));
    }

    /** A SIM with a key. */
    static Sim of(InsertedCard card) {
        return new KeyedSim(card.card(), card.lock());
    }

    /** The check of the card's user, the same at each call. */
    default PinLock lock() {
        return OPEN;
    }

    /**
     * @param rand 16 octets
     * @param autn 16 octets for a USIM's challenge, empty for a SIM's
     */
    AuthenticationResult authenticate(OctetString rand, Optional<OctetString> autn);

    /**
     * A response or the cause of its absence.
     *
     * @param response SRES or RES, 4 to 16 octets
     * @param kc the ciphering key of the challenge, 8 octets, with a response only
     * @param failure MAC_FAILURE or SYNCH_FAILURE
     * @param auts resynchronisation token, 14 octets, with SYNCH_FAILURE only
     */
    record AuthenticationResult(
            Optional<OctetString> response,
            Optional<OctetString> kc,
            Optional<RejectCause> failure,
            Optional<OctetString> auts) {
        public AuthenticationResult {
            if (response.isPresent() == failure.isPresent()) {
                throw new IllegalArgumentException("expected either a response or a failure");
            }
        }

        public static AuthenticationResult response(OctetString response, OctetString kc) {
            return new AuthenticationResult(Optional.of(response), Optional.of(kc), Optional.empty(), Optional.empty());
        }

        public static AuthenticationResult failure(RejectCause cause, Optional<OctetString> auts) {
            return new AuthenticationResult(Optional.empty(), Optional.empty(), Optional.of(cause), auts);
        }
    }
}
