package simgsm.cells.tower;

import java.util.Set;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.air.Cause;
import simgsm.air.CipherAlgorithm;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Type;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.Octets;

/** The encryption information of a channel (TS 48.058, 9.3.7). @param kc 8 octets, empty for A5/0 */
record CipherKey(CipherAlgorithm algorithm, OctetString kc) {
    static final CipherKey NONE = new CipherKey(CipherAlgorithm.A5_0, OctetString.of(new byte[0]));

    private static final int KC_LENGTH = 8;

    /** @throws ProtocolViolation for an algorithm that the tower does not have, or a key of another length */
    static CipherKey of(RslPdu message, Set<CipherAlgorithm> known) throws ProtocolViolation {
        byte[] octets = message.value(RslElement.ENCRYPTION_INFORMATION).toArray();
        if (octets.length == 0) {
            throw ProtocolViolation.invalid("encryption information without algorithm");
        }
        CipherAlgorithm algorithm = CipherAlgorithm.ofRsl(octets[0])
                .filter(found -> found == CipherAlgorithm.A5_0 || known.contains(found))
                .orElseThrow(() -> new ProtocolViolation(
                        Cause.SERVICE_NOT_IMPLEMENTED, "encryption algorithm " + octets[0] + " is not that of --a5"));
        if (algorithm == CipherAlgorithm.A5_0) {
            return NONE;
        }
        if (octets.length != 1 + KC_LENGTH) {
            throw ProtocolViolation.invalid("a key of " + (octets.length - 1) + " octets, expected " + KC_LENGTH);
        }
        return new CipherKey(algorithm, OctetString.of(Octets.range(octets, 1, octets.length)));
    }

    boolean isCiphering() {
        return algorithm != CipherAlgorithm.A5_0;
    }

    /** True for CIPHERING MODE COMPLETE of a mobile. */
    static boolean isComplete(OctetString layer3) {
        return layer3.length() > 1
                && layer3.octet(0) == Layer3Header.RADIO_RESOURCE
                && layer3.octet(1) == Layer3Type.CIPHERING_MODE_COMPLETE.code();
    }
}
