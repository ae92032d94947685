package simgsm.smpp;

import java.util.List;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** Writes one PDU. */
final class SmppWriter implements SmppFields {
    private final OctetWriter out = new OctetWriter();
    private final boolean writesParameters;

    /** @param writesParameters true if the peer accepts optional parameters: from SMPP 3.4 on (3.4.2) */
    SmppWriter(boolean writesParameters) {
        this.writesParameters = writesParameters;
    }

    @Override
    public int octet(String field, int value) {
        out.octet(value);
        return value;
    }

    @Override
    public int octet(String field, int value, int most, int status) {
        return octet(field, value);
    }

    @Override
    public int fourOctets(String field, int value) {
        out.fourOctets(value);
        return value;
    }

    @Override
    public String text(String field, int most, int status, String value) {
        out.zeroEnded(value);
        return value;
    }

    @Override
    public OctetString shortMessage(OctetString value) {
        out.octet(value.length()).string(value);
        return value;
    }

    @Override
    public List<Tlv> parameters(List<Tlv> values) {
        for (Tlv each : writesParameters ? values : List.<Tlv>of()) {
            out.twoOctets(each.tag()).twoOctets(each.value().length()).string(each.value());
        }
        return values;
    }

    /** The PDU with its command_length, written as 0 until now. */
    byte[] toArray() {
        byte[] octets = out.toArray();
        for (int i = 0; i < 4; i++) {
            octets[i] = (byte) (octets.length >> 8 * (3 - i));
        }
        return octets;
    }
}
