package simgsm.center.bsc;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import simgsm.air.LocationArea;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.rr.FrequencyList;
import simgsm.rr.NeighbourList;

/**
 * The system information of a cell as osmo-bsc encodes it (TS 44.018, 9.1.31 to 9.1.40): 23 octets on the BCCH, 18 or 11 on the SACCH, each with
 * its L2 pseudo length.
 */
final class SystemInformationBlocks {
    private static final int RADIO_RESOURCE = 0x06;
    private static final int FILL = 0x2b;
    private static final int BLOCK = 23;
    /** BA-IND in the first octet of a frequency list (TS 44.018, 10.5.2.22). */
    private static final byte SECOND_LIST = 0x10;
    /** EXT-IND: the list is a part of those of its band. */
    private static final byte IS_PART = 0x20;

    private static final int ALL_COLOUR_CODES = 0xff;
    /** Up to 7 repetitions, spread over 12 slots, no re-establishment, access class 10 barred (emergency calls). */
    private static final int[] RANDOM_ACCESS = {0xe5, 0x04, 0x00};
    /** Attach and detach required, one block for access grant, common channels with SDCCH/4; paging in 5 multiframes. */
    private static final int[] CONTROL_CHANNEL = {0xc9, 0x03};
    /** No uplink DTX on TCH; radio link time-out in the low half. */
    private static final int NO_DTX = 0x20;

    private static final int NECI = 0x40;

    private final TowerPlan plan;
    private final NeighbourFrequencies neighbours;
    private final CellSettings settings;

    SystemInformationBlocks(TowerPlan plan, NeighbourFrequencies neighbours, CellSettings settings) {
        this.plan = plan;
        this.neighbours = neighbours;
        this.settings = settings;
    }

    /** The cell's own frequencies. */
    OctetString type1() {
        OctetWriter out =
                begin(21, 0x19).string(FrequencyList.encode(List.of(plan.cell().frequency())));
        return filled(access(out), BLOCK);
    }

    /**
     * The lists of neighbours that the cell sends. Those for mobiles on a dedicated channel are marked as the second list,
     * which reports name by BA-USED.
     */
    Map<NeighbourList, OctetString> lists() {
        Map<NeighbourList, OctetString> lists = new EnumMap<>(NeighbourList.class);
        lists.put(NeighbourList.TYPE_2, list(NeighbourList.TYPE_2, neighbours.first()));
        lists.put(NeighbourList.TYPE_5, list(NeighbourList.TYPE_5, neighbours.first()));
        if (!neighbours.more().isEmpty()) {
            lists.put(NeighbourList.TYPE_2_BIS, list(NeighbourList.TYPE_2_BIS, neighbours.more()));
            lists.put(NeighbourList.TYPE_5_BIS, list(NeighbourList.TYPE_5_BIS, neighbours.more()));
        }
        if (!neighbours.other().isEmpty()) {
            lists.put(NeighbourList.TYPE_2_TER, list(NeighbourList.TYPE_2_TER, neighbours.other()));
            lists.put(NeighbourList.TYPE_5_TER, list(NeighbourList.TYPE_5_TER, neighbours.other()));
        }
        return lists;
    }

    private OctetString list(NeighbourList list, List<Integer> arfcns) {
        byte[] octets = FrequencyList.encode(arfcns).toArray();
        octets[0] |= list.isDedicated() ? SECOND_LIST : 0;
        octets[0] |= list.isOfOtherBands() || neighbours.more().isEmpty() ? 0 : IS_PART;
        OctetWriter out = begin(list.pseudoLength(), list.messageType()).bytes(octets);
        if (list.isDedicated()) {
            return out.toOctetString();
        }
        if (list == NeighbourList.TYPE_2) {
            out.octet(ALL_COLOUR_CODES);
        }
        return filled(list.isOfOtherBands() ? out : access(out), BLOCK);
    }

    /** The cell. */
    OctetString type3() {
        OctetWriter out = begin(18, 0x1b).twoOctets(plan.cellIdentity());
        octets(area(out), CONTROL_CHANNEL).octet(settings.t3212SixMinutes()).octet(options());
        selection(out);
        return filled(access(out).octet(0x29), BLOCK);
    }

    /** A part of type 3, sent more often. */
    OctetString type4() {
        OctetWriter out = area(begin(12, 0x1c));
        selection(out);
        return filled(access(out), BLOCK);
    }

    /** The cell, for mobiles on a dedicated channel. */
    OctetString type6() {
        OctetWriter out = area(begin(11, 0x1e).twoOctets(plan.cellIdentity()));
        return out.octet(options()).octet(ALL_COLOUR_CODES).octet(FILL).toOctetString();
    }

    private static OctetWriter begin(int pseudoLength, int type) {
        return new OctetWriter()
                .octet(pseudoLength << 2 | 1)
                .octet(RADIO_RESOURCE)
                .octet(type);
    }

    private static OctetWriter octets(OctetWriter out, int... values) {
        for (int value : values) {
            out.octet(value);
        }
        return out;
    }

    private static OctetWriter access(OctetWriter out) {
        return octets(out, RANDOM_ACCESS);
    }

    /**
     * Cell selection parameters (10.5.2.4): hysteresis in steps of 2 dB, power level; NECI, minimum level for access.
     */
    private void selection(OctetWriter out) {
        octets(out, plan.hysteresisDecibels() / 2 << 5 | plan.powerLevel(), NECI | plan.accessMinimum());
    }

    private int options() {
        return NO_DTX | plan.radioLinkTimeout() / 4 - 1;
    }

    private OctetWriter area(OctetWriter out) {
        LocationArea area = plan.area();
        String country = area.countryCode();
        String network = area.networkCode();
        int third = network.length() == 3 ? digit(network, 2) : 0x0f;
        return out.octet(digit(country, 1) << 4 | digit(country, 0))
                .octet(third << 4 | digit(country, 2))
                .octet(digit(network, 1) << 4 | digit(network, 0))
                .twoOctets(area.areaCode());
    }

    private static int digit(String digits, int index) {
        return digits.charAt(index) - '0';
    }

    private static OctetString filled(OctetWriter out, int length) {
        while (out.length() < length) {
            out.octet(FILL);
        }
        return out.toOctetString();
    }
}
