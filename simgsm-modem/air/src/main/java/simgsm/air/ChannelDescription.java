package simgsm.air;

import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * A channel without frequency hopping (TS 44.018, 10.5.2.5).
 *
 * @param trainingSequence training sequence code, 0 to 7
 * @param frequency ARFCN, 0 to 1023
 */
public record ChannelDescription(ChannelNumber channel, int trainingSequence, int frequency) {
    /** Octets of the value. */
    public static final int LENGTH = 3;

    public ChannelDescription {
        Bounds.check("training sequence code", trainingSequence, 0, 7);
        Bounds.check("ARFCN", frequency, 0, 1023);
    }

    /** The three octets. */
    public OctetString encode() {
        return new OctetWriter()
                .octet(channel.code())
                .twoOctets(trainingSequence << 13 | frequency)
                .toOctetString();
    }

    /** The description of the next three octets. @throws ProtocolViolation for a hopping channel */
    public static ChannelDescription read(MessageReader in) throws ProtocolViolation {
        ChannelNumber channel = ChannelNumber.ofCode(in.octet("channel number"));
        int rest = in.twoOctets("channel description");
        if ((rest & 0x1000) != 0) {
            throw ProtocolViolation.invalid("a hopping channel, which no terminal here has");
        }
        return new ChannelDescription(channel, rest >> 13, rest & 0x3ff);
    }

    /** As "TCH/F 2 of ARFCN 100, TSC 2". */
    @Override
    public String toString() {
        return channel + " of ARFCN " + frequency + ", TSC " + trainingSequence;
    }
}
