package simgsm.air;

import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * How a mobile finds a cell (TS 44.018, 10.5.2.2).
 *
 * @param identityCode base station identity code: network colour code in bits 6-4, base station colour code in bits 3-1
 * @param frequency ARFCN of the BCCH, 0 to 1023
 */
public record CellDescription(int identityCode, int frequency) {
    public CellDescription {
        Bounds.check("BSIC", identityCode, 0, 63);
        Bounds.check("ARFCN", frequency, 0, 1023);
    }

    /** The two octets. */
    public OctetString encode() {
        return new OctetWriter()
                .octet(frequency >> 8 << 6 | identityCode)
                .octet(frequency)
                .toOctetString();
    }

    /** The description of the next two octets. */
    public static CellDescription read(MessageReader in) throws ProtocolViolation {
        int first = in.octet("cell description");
        return new CellDescription(first & 0x3f, (first & 0xc0) << 2 | in.octet("cell description"));
    }

    /** As "ARFCN 110, BSIC 11". */
    @Override
    public String toString() {
        return "ARFCN " + frequency + ", BSIC " + identityCode;
    }
}
