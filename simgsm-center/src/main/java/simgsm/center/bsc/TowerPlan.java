package simgsm.center.bsc;

import java.util.ArrayList;
import java.util.List;
import simgsm.abis.CcmMessage;
import simgsm.abis.TowerIdentity;
import simgsm.air.ChannelNumber;
import simgsm.air.LocationArea;
import simgsm.air.RadioResource.CellDescription;
import simgsm.rr.Band;

/**
 * A tower's parameters in the network. A tower that sends only its unit id gets the first unused of ARFCN 100 with BSIC
 * 10, 110 with 11 ..., and location area 1.
 *
 * @param cell ARFCN of its one carrier, and BSIC
 * @param cellIdentity 0 to 65535
 * @param trafficChannels timeslots for speech, the last ones
 * @param radioLinkTimeout SACCH blocks, 4 to 64 in steps of 4
 * @param accessMinimum RXLEV_ACCESS_MIN, 0 to 63
 */
record TowerPlan(
        String name,
        CellDescription cell,
        LocationArea area,
        int cellIdentity,
        int trafficChannels,
        int radioLinkTimeout,
        int accessMinimum,
        int hysteresisDecibels) {
    private static final int TIMESLOTS = 8;
    /** Output of all mobiles, as osmo-bsc orders it without other configuration. */
    private static final int MOBILE_DBM = 15;

    /**
     * The plan of a tower.
     *
     * @param position from 0, selects the defaults of missing parameters
     */
    static TowerPlan of(CcmMessage.IdentityResponse identity, int position) {
        TowerIdentity tower = TowerIdentity.of(identity, position);
        return new TowerPlan(
                tower.name(),
                new CellDescription(tower.identityCode(), tower.frequency()),
                new LocationArea(LocationArea.TEST.countryCode(), LocationArea.TEST.networkCode(), tower.area()),
                tower.cellIdentity(),
                tower.trafficChannels(),
                tower.radioLinkTimeout(),
                tower.accessMinimum(),
                tower.hysteresisDecibels());
    }

    /**
     * The dedicated channels in the order of their assignment: SDCCH/4 with the common channels in timeslot 0, traffic
     * channels in the last timeslots, SDCCH/8 in those between.
     */
    List<ChannelNumber> channels() {
        List<ChannelNumber> channels = new ArrayList<>();
        addSignalling(channels, ChannelNumber.Kind.SDCCH_4, 0);
        for (int timeslot = 1; timeslot < TIMESLOTS; timeslot++) {
            if (timeslot < TIMESLOTS - trafficChannels) {
                addSignalling(channels, ChannelNumber.Kind.SDCCH_8, timeslot);
            } else {
                channels.add(ChannelNumber.of(ChannelNumber.Kind.TCH_F, timeslot));
            }
        }
        return channels;
    }

    private static void addSignalling(List<ChannelNumber> channels, ChannelNumber.Kind kind, int timeslot) {
        for (int i = 0; i < kind.subchannels(); i++) {
            channels.add(new ChannelNumber(kind, i, timeslot));
        }
    }

    /** Power control level of mobiles. */
    int powerLevel() {
        return Band.of(cell.frequency()).level(MOBILE_DBM);
    }

    /** The training sequence of all channels, equal to the base station's colour code. */
    int trainingSequence() {
        return cell.identityCode() & 0x07;
    }
}
