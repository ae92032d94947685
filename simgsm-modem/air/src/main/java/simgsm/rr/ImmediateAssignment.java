package simgsm.rr;

import simgsm.air.ChannelDescription;
import simgsm.air.Layer3Header;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * IMMEDIATE ASSIGNMENT on the access grant channel (TS 44.018, 9.1.18): grants the channel of a CHANNEL REQUEST.
 *
 * @param timingAdvance 0 to 63, steps of 553.5 m
 */
public record ImmediateAssignment(ChannelDescription channel, RequestReference reference, int timingAdvance) {
    static final int OCTETS = 23;
    static final int FILL = 0x2b;
    /** Page mode: the mobiles listen to paging as before. */
    static final int SAME_PAGE_MODE = 3;

    private static final int TYPE = 0x3f;
    /** Octets counted by the L2 pseudo length, without a mobile allocation. */
    private static final int COUNTED_OCTETS = 11;

    public ImmediateAssignment {
        Bounds.check("timing advance", timingAdvance, 0, 63);
    }

    /** The 23 octets with L2 pseudo length and fill octets. */
    public OctetString encode() {
        OctetWriter out = new OctetWriter()
                .octet(COUNTED_OCTETS << 2 | 1)
                .octet(Layer3Header.RADIO_RESOURCE)
                .octet(TYPE)
                .octet(SAME_PAGE_MODE)
                .string(channel.encode())
                .string(reference.octets())
                .octet(timingAdvance)
                .octet(0);
        while (out.length() < OCTETS) {
            out.octet(FILL);
        }
        return out.toOctetString();
    }

    /** True if these octets of an access grant channel are this message. */
    public static boolean isOne(OctetString octets) {
        return octets.length() > 2 && octets.octet(1) == Layer3Header.RADIO_RESOURCE && octets.octet(2) == TYPE;
    }

    public static ImmediateAssignment decode(OctetString octets) throws ProtocolViolation {
        MessageReader in = new MessageReader(octets);
        in.bytes(4, "immediate assignment");
        ChannelDescription channel = ChannelDescription.read(in);
        RequestReference reference = RequestReference.read(in);
        return new ImmediateAssignment(channel, reference, in.octet("timing advance") & 0x3f);
    }
}
