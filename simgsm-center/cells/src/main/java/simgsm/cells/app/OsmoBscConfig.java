package simgsm.cells.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import simgsm.cells.town.CellSelection;
import simgsm.cells.town.Tower;
import simgsm.cells.town.Town;
import simgsm.octets.OctetString;
import simgsm.rr.Band;
import simgsm.rr.FrequencyList;

/** The configuration of osmo-bsc 1.9 for the towers of a town: one base station per tower, handover by algorithm 1. */
final class OsmoBscConfig {
    private static final int TIME_SLOTS = 8;
    /** BA-IND of SYSTEM INFORMATION TYPE 5 in osmo-bsc. */
    private static final byte SECOND_LIST = 0x10;

    private OsmoBscConfig() {}

    static String of(Town town) {
        StringBuilder text = new StringBuilder("""
                e1_input
                 e1_line 0 driver ipa
                network
                 network country code 1
                 mobile network code 1
                 encryption a5 0
                 neci 1
                 paging any use tch 0
                 handover 1
                 handover algorithm 1
                 handover1 window rxlev averaging 10
                 handover1 window rxqual averaging 1
                 handover1 window rxlev neighbor averaging 10
                 handover1 power budget interval 6
                 handover1 power budget hysteresis 3
                 handover1 maximum distance 9999
                """);
        for (int i = 0; i < town.towers().size(); i++) {
            append(text, i, town.towers().get(i), town);
        }
        return text.append("""
                        msc 0
                         allow-emergency allow
                         mgw remote-ip 127.0.0.1
                         mgw remote-port 2427
                         mgw local-port 2727
                        bsc
                         mid-call-timeout 0
                        log stderr
                         logging color 0
                         logging filter all 1
                         logging print category 1
                         logging level set-all notice
                        """).toString();
    }

    private static void append(StringBuilder text, int number, Tower tower, Town town) {
        CellSelection selection = tower.selection();
        Band band = Band.of(tower.arfcn());
        line(text, " bts %d", number);
        line(text, "  type osmo-bts");
        line(text, "  band %s", band.name().replace("_", ""));
        line(text, "  cell_identity %d", tower.cellIdentity());
        line(text, "  location_area_code %d", tower.area());
        line(text, "  base_station_id_code %d", tower.bsic());
        line(text, "  ms max power %d", band.fullDbm());
        line(text, "  cell reselection hysteresis %d", selection.hysteresisDecibels());
        line(text, "  rxlev access min %d", selection.accessMinimumRxlev());
        line(text, "  radio-link-timeout %d", town.radioLinkTimeout());
        line(text, "  channel allocator ascending");
        line(text, "  rach tx integer 9");
        line(text, "  rach max transmission 7");
        line(text, "  rach emergency call allowed 1");
        line(text, "  channel-description attach 1");
        line(text, "  channel-description bs-pa-mfrms 2");
        line(text, "  channel-description bs-ag-blks-res 1");
        line(text, "  early-classmark-sending forbidden");
        line(text, "  ipa unit-id %d 0", tower.site());
        line(text, "  oml ipa stream-id 255 line 0");
        line(text, "  codec-support fr");
        line(text, "  gprs mode none");
        appendNeighbours(text, tower, town);
        line(text, "  trx 0");
        line(text, "   rf_locked 0");
        line(text, "   arfcn %d", tower.arfcn());
        line(text, "   nominal power 23");
        line(text, "   max_power_red 0");
        line(text, "   rsl e1 tei 0");
        appendTimeSlots(text, tower);
    }

    private static void appendTimeSlots(StringBuilder text, Tower tower) {
        for (int slot = 0; slot < TIME_SLOTS; slot++) {
            line(text, "   timeslot %d", slot);
            line(text, "    phys_chan_config %s", channels(tower, slot));
            line(text, "    hopping enabled 0");
        }
    }

    /**
     * Neighbours that osmo-bsc 1.9 would list wrongly: its lists in a range format name other frequencies, and it takes the
     * numbers in reports as those of all frequencies in ascending order, where mobiles number the cell's band first.
     */
    private static void appendNeighbours(StringBuilder text, Tower tower, Town town) {
        List<Integer> all = town.towers().stream()
                .filter(other -> other != tower)
                .map(Tower::arfcn)
                .distinct()
                .sorted()
                .toList();
        Map<Boolean, List<Integer>> byBand =
                all.stream().collect(Collectors.partitioningBy(arfcn -> Band.of(arfcn) != Band.of(tower.arfcn())));
        List<Integer> inReports = new ArrayList<>(byBand.get(false));
        inReports.addAll(byBand.get(true));
        boolean isRight = inReports.equals(all) && byBand.values().stream().noneMatch(FrequencyList::isRange);
        Optional<OctetString> combined = FrequencyList.find(all);
        if (isRight || combined.isEmpty()) {
            return;
        }
        byte[] list = combined.get().toArray();
        line(text, "  force-combined-si");
        line(text, "  system-information 2 mode static");
        line(text, "  system-information 2 static 59061a%sffe50400", OctetString.of(list));
        list[0] |= SECOND_LIST;
        line(text, "  system-information 5 mode static");
        // without its L2 pseudo length: osmo-bsc sends 18 octets of it
        line(text, "  system-information 5 static 061d%s", OctetString.of(list));
    }

    /** Traffic channels are the last time slots; those between them and slot 0 carry signalling. */
    private static String channels(Tower tower, int slot) {
        if (slot == 0) {
            return "CCCH+SDCCH4";
        }
        return slot >= TIME_SLOTS - tower.trafficChannels() ? "TCH/F" : "SDCCH8";
    }

    private static void line(StringBuilder text, String pattern, Object... values) {
        text.append(String.format(Locale.ROOT, pattern, values)).append('\n');
    }
}
