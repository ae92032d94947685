package simgsm.cells.cipher;

import java.util.Set;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.air.Cause;
import simgsm.air.CipherAlgorithm;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.Octets;

/** The encryption information of a channel (TS 48.058, 9.3.7). @param kc 8 octets, empty for A5/0 */
public record CipherKey(CipherAlgorithm algorithm, OctetString kc) {
    public static final CipherKey NONE = new CipherKey(CipherAlgorithm.A5_0, OctetString.of(new byte[0]));

    /** Bits of a burst that are ciphered. */
    public static final int BURST_BITS = 114;

    private static final int KC_LENGTH = 8;
    private static final int TRAFFIC_FRAMES = 26;
    private static final int CONTROL_FRAMES = 51;
    private static final int SUPERFRAMES = 2_048;

    /** @throws ProtocolViolation for an algorithm that the tower does not have, or a key of another length */
    public static CipherKey of(RslPdu message, Set<CipherAlgorithm> known) throws ProtocolViolation {
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

    public boolean isCiphering() {
        return algorithm != CipherAlgorithm.A5_0;
    }

    /**
     * The key stream of one burst.
     *
     * @param frame the frame's number
     * @return 114 bits, each an octet 0 or 1
     */
    public byte[] stream(long frame, boolean isUplink) {
        int count = (int) (frame / (TRAFFIC_FRAMES * CONTROL_FRAMES) % SUPERFRAMES) << 11
                | (int) (frame % CONTROL_FRAMES) << 5
                | (int) (frame % TRAFFIC_FRAMES);
        byte[] both = switch (algorithm) {
            case A5_1 -> A51.stream(kc.toArray(), count, 2 * BURST_BITS);
            case A5_3 -> A53.stream(kc.toArray(), count, 2 * BURST_BITS);
            default -> new byte[2 * BURST_BITS];
        };
        // the first half is for the downlink
        return Octets.range(both, isUplink ? BURST_BITS : 0, isUplink ? 2 * BURST_BITS : BURST_BITS);
    }
}
