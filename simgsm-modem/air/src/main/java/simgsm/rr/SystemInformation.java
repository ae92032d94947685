package simgsm.rr;

import java.util.List;
import java.util.Optional;
import simgsm.air.LocationArea;
import simgsm.air.MessageReader;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * SYSTEM INFORMATION (TS 44.018, 9.1.31 to 9.1.40), broadcast by a cell to all mobiles and sent on dedicated
 * channels.
 */
public sealed interface SystemInformation {
    /** A list of neighbours. @param arfcns in the order of reports */
    record Neighbours(NeighbourList list, List<Integer> arfcns) implements SystemInformation {}

    /** TYPE 3 on the BCCH. */
    record Type3(
            int cellIdentity,
            LocationArea area,
            ControlChannel control,
            int radioLinkTimeout,
            SelectionParameters selection,
            RandomAccess access,
            Optional<Reselection> reselection)
            implements SystemInformation {}

    /** TYPE 6 on the slow associated channel. */
    record Type6(int cellIdentity, LocationArea area, int radioLinkTimeout) implements SystemInformation {}

    /**
     * Control channel description (10.5.2.11).
     *
     * @param blocksForAccessGrant BS_AG_BLKS_RES; @param isCombined true if the common channels share their timeslot
     *     with an SDCCH/4
     * @param pagingMultiframes BS_PA_MFRMS, 2 to 9; @param t3212 in units of 6 minutes, 0 for no periodic updating
     */
    record ControlChannel(
            boolean isAttachNeeded, int blocksForAccessGrant, boolean isCombined, int pagingMultiframes, int t3212) {
        /** Paging blocks in a multiframe of 51 frames (TS 45.002, 6.5). */
        public int pagingBlocks() {
            return (isCombined ? 3 : 9) - blocksForAccessGrant;
        }

        /** Paging groups of the cell; a mobile's group is the IMSI's last three digits modulo this. */
        public int pagingGroups() {
            return pagingBlocks() * pagingMultiframes;
        }
    }

    /**
     * Cell selection parameters (10.5.2.4).
     *
     * @param hysteresisDecibels CELL_RESELECT_HYSTERESIS; @param powerLevel MS_TXPWR_MAX_CCH; @param accessMin
     *     RXLEV_ACCESS_MIN, 0 to 63
     */
    record SelectionParameters(int hysteresisDecibels, int powerLevel, int accessMin) {}

    /**
     * RACH control parameters (10.5.2.29).
     *
     * @param attempts after the first CHANNEL REQUEST: 1, 2, 4 or 7; @param spreadSlots TX_INTEGER, 3 to 50 slots
     */
    record RandomAccess(int attempts, int spreadSlots, boolean isBarred) {}

    /**
     * C2 parameters (10.5.2.34).
     *
     * @param offsetDecibels CELL_RESELECT_OFFSET; @param temporaryOffsetDecibels positive infinity for the largest
     * @param penaltySeconds PENALTY_TIME, 20 to 620; -1 if the offset is subtracted permanently
     */
    record Reselection(int offsetDecibels, double temporaryOffsetDecibels, int penaltySeconds) {}

    /** The message's octets with their L2 pseudo length, as in RSL; lists of neighbours without what follows them. */
    default OctetString encode() {
        OctetWriter out = new OctetWriter();
        SystemInformationCodec.write(out, this);
        return out.toOctetString();
    }

    /** The information of octets with or without an L2 pseudo length; empty for an unknown type. */
    static Optional<SystemInformation> decode(OctetString octets) throws ProtocolViolation {
        MessageReader in = new MessageReader(octets);
        return SystemInformationCodec.read(in);
    }
}
