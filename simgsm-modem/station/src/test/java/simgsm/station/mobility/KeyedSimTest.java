package simgsm.station.mobility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.octets.OctetString;
import simgsm.sim.SimCard;

/** Test set 1 of TS 35.208, whose AUTN is SQN xor AK, AMF and MAC-A. */
class KeyedSimTest {
    private static final OctetString RAND = OctetString.ofHex("23553cbe9637a89d218ae64dae47bf35");
    private static final OctetString AUTN = OctetString.ofHex("55f328b43577b9b94a9ffac354dfafb3");

    private static final OctetString KC = OctetString.ofHex("eae4be823af9a08b");

    private final Sim sim = Sim.of(new SimCard(
            new Imsi("001010005550100"),
            new Msisdn("5550100"),
            OctetString.ofHex("465b5ce8b199b49faa5f0a2ee238a6bc"),
            OctetString.ofHex("cd63cb71954a9f4e48a5994e37a02baf")));

    @Test
    void aGsmChallengeIsAnsweredWithSres() {
        assertEquals(
                Sim.AuthenticationResult.response(OctetString.ofHex("46f8416a"), KC),
                sim.authenticate(RAND, Optional.empty()));
    }

    @Test
    void aChallengeOfItsOwnNetworkIsAnsweredWithRes() {
        assertEquals(
                Sim.AuthenticationResult.response(OctetString.ofHex("a54211d5e3ba50bf"), KC),
                sim.authenticate(RAND, Optional.of(AUTN)));
    }

    @Test
    void aChallengeThatAnotherNetworkMadeIsRefused() {
        OctetString forged = OctetString.ofHex(AUTN.toString().replaceFirst("b3$", "b4"));
        assertEquals(
                Sim.AuthenticationResult.failure(RejectCause.MAC_FAILURE, Optional.empty()),
                sim.authenticate(RAND, Optional.of(forged)));
    }

    /** AUTS is the highest SQN xor AK* (set 1: 451e8beca43b), then MAC-S with AMF 0. */
    @Test
    void aChallengeThatComesAgainIsAnsweredWithTheNumberThatIsDue() {
        sim.authenticate(RAND, Optional.of(AUTN));
        Sim.AuthenticationResult second = sim.authenticate(RAND, Optional.of(AUTN));
        assertEquals(Optional.of(RejectCause.SYNCH_FAILURE), second.failure());
        OctetString auts = second.auts().orElseThrow();
        assertEquals(14, auts.length());
        assertEquals("ba853f3c123c", auts.toString().substring(0, 12));
    }
}
