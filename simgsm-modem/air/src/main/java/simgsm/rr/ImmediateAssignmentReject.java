package simgsm.rr;

import java.util.ArrayList;
import java.util.List;
import simgsm.air.Layer3Header;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * IMMEDIATE ASSIGNMENT REJECT (TS 44.018, 9.1.20): refuses up to four CHANNEL REQUESTs.
 *
 * @param waitSeconds least time before the mobiles may repeat, 0 to 255
 */
public record ImmediateAssignmentReject(List<RequestReference> references, int waitSeconds) {
    public static final int MOST = 4;
    private static final int TYPE = 0x3a;
    private static final int COUNTED_OCTETS = 19;

    public ImmediateAssignmentReject {
        references = List.copyOf(references);
        Bounds.check("number of refused requests", references.size(), 1, MOST);
        Bounds.checkOctet("wait indication", waitSeconds);
    }

    /** The 23 octets; unused places repeat the last request. */
    public OctetString encode() {
        OctetWriter out = new OctetWriter()
                .octet(COUNTED_OCTETS << 2 | 1)
                .octet(Layer3Header.RADIO_RESOURCE)
                .octet(TYPE)
                .octet(ImmediateAssignment.SAME_PAGE_MODE);
        for (int i = 0; i < MOST; i++) {
            references.get(Math.min(i, references.size() - 1)).write(out);
            out.octet(waitSeconds);
        }
        while (out.length() < ImmediateAssignment.OCTETS) {
            out.octet(ImmediateAssignment.FILL);
        }
        return out.toOctetString();
    }

    /** True if these octets of an access grant channel are this message. */
    public static boolean isOne(OctetString octets) {
        return octets.length() > 2 && octets.octet(1) == Layer3Header.RADIO_RESOURCE && octets.octet(2) == TYPE;
    }

    public static ImmediateAssignmentReject decode(OctetString octets) throws ProtocolViolation {
        MessageReader in = new MessageReader(octets);
        in.bytes(4, "immediate assignment reject");
        List<RequestReference> references = new ArrayList<>();
        int waitSeconds = 0;
        for (int i = 0; i < MOST; i++) {
            references.add(RequestReference.read(in));
            waitSeconds = in.octet("wait indication");
        }
        return new ImmediateAssignmentReject(references.stream().distinct().toList(), waitSeconds);
    }
}
