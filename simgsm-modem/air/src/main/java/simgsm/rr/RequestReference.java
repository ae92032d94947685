package simgsm.rr;

import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * Names one CHANNEL REQUEST (TS 44.018, 10.5.2.30): the octet sent and the TDMA frame in which it was received.
 *
 * @param access the CHANNEL REQUEST: establishment cause and random reference
 * @param frame frame number modulo 42 432, as 5 bits of T1, 6 of T3 and 5 of T2
 */
public record RequestReference(int access, int frame) {
    private static final int FRAMES = 42_432;
    private static final int MULTIFRAME = 51;
    private static final int TRAFFIC_MULTIFRAME = 26;

    public RequestReference {
        Bounds.checkOctet("CHANNEL REQUEST", access);
        Bounds.check("frame number", frame, 0, 0xffff);
    }

    /** The reference of a CHANNEL REQUEST in the frame of this number. */
    public static RequestReference at(int access, long frameNumber) {
        int frame = (int) (frameNumber % FRAMES);
        int t1 = frame / (MULTIFRAME * TRAFFIC_MULTIFRAME);
        return new RequestReference(access, t1 << 11 | frame % MULTIFRAME << 5 | frame % TRAFFIC_MULTIFRAME);
    }

    /** The three octets of the element. */
    public OctetString octets() {
        OctetWriter out = new OctetWriter();
        write(out);
        return out.toOctetString();
    }

    public static RequestReference of(OctetString octets) throws ProtocolViolation {
        return read(new MessageReader(octets));
    }

    void write(OctetWriter out) {
        out.octet(access).twoOctets(frame);
    }

    static RequestReference read(MessageReader in) throws ProtocolViolation {
        return new RequestReference(in.octet("CHANNEL REQUEST"), in.twoOctets("frame number"));
    }
}
