package simgsm.air;

import simgsm.octets.Bounds;

/**
 * A channel of a carrier (TS 48.058, 9.3.1; TS 44.018, 10.5.2.5).
 *
 * @param subchannel 0 up to the number of channels of this kind in a timeslot
 * @param timeslot 0 to 7
 */
public record ChannelNumber(Kind kind, int subchannel, int timeslot) {
    /** The use of a timeslot or a part of it. */
    public enum Kind {
        /** Speech at full rate. */
        TCH_F(0x08, 1),
        /** Speech at half rate. */
        TCH_H(0x10, 2),
        /** Signalling besides the common channels. */
        SDCCH_4(0x20, 4),
        SDCCH_8(0x40, 8),
        BCCH(0x80, 1),
        RACH(0x88, 1),
        /** Paging and access grant. */
        PCH_AGCH(0x90, 1);

        private final int code;
        private final int subchannels;

        Kind(int code, int subchannels) {
            this.code = code;
            this.subchannels = subchannels;
        }

        /** Channels of this kind in a timeslot. */
        public int subchannels() {
            return subchannels;
        }

        public boolean isSpeech() {
            return this == TCH_F || this == TCH_H;
        }
    }

    public ChannelNumber {
        Bounds.check("subchannel", subchannel, 0, kind.subchannels - 1);
        Bounds.check("timeslot", timeslot, 0, 7);
    }

    /** A channel without subchannels. */
    public static ChannelNumber of(Kind kind, int timeslot) {
        return new ChannelNumber(kind, 0, timeslot);
    }

    /** The octet. */
    public int code() {
        return kind.code + (subchannel << 3) + timeslot;
    }

    /** The channel of an octet. @throws ProtocolViolation for an undefined code */
    public static ChannelNumber ofCode(int octet) throws ProtocolViolation {
        for (Kind kind : Kind.values()) {
            int subchannel = (octet - kind.code) >> 3;
            if (octet >= kind.code && subchannel < kind.subchannels) {
                return new ChannelNumber(kind, subchannel, octet & 0x07);
            }
        }
        throw ProtocolViolation.invalid(String.format("channel number 0x%02x is not known", octet));
    }

    /** As "TCH/F 3" or "SDCCH/4 2 of 0". */
    @Override
    public String toString() {
        String name = kind.name().replace('_', '/');
        return kind.subchannels == 1 ? name + " " + timeslot : name + " " + subchannel + " of " + timeslot;
    }
}
