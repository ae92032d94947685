package simgsm.cells.mobile;

import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Optional;
import simgsm.air.MeasurementResults;
import simgsm.cells.cipher.CipherKey;
import simgsm.cells.radio.FrameLosses;
import simgsm.cells.radio.RadioScale;
import simgsm.cells.radio.ReceptionQuality;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.tower.TowerChannel;
import simgsm.cells.town.Frequencies;

/**
 * The reception between a mobile and the tower of its channel: quality, lost frames and blocks, reports, the link's
 * end.
 */
public final class RadioLink {
    private static final System.Logger LOG = System.getLogger(RadioLink.class.getName());
    /** Share of lost blocks above which the link layer's repetitions fail. */
    private static final double UNUSABLE = 0.9;

    private static final int STANDARD_TIMEOUT = 32;

    private final Mobile mobile;
    private final MobileNetwork network;
    private final Reception reception;
    private final RecentLevels recent;
    private final FrameLosses downlinkLosses;
    private final FrameLosses uplinkLosses;
    private RadioLinkCounter downlink = new RadioLinkCounter(STANDARD_TIMEOUT);
    private RadioLinkCounter uplink = new RadioLinkCounter(STANDARD_TIMEOUT);
    private CipherKey key = CipherKey.NONE;
    private int reports;
    private int quality;
    private double erasure;

    RadioLink(Mobile mobile, MobileNetwork network, Reception reception) {
        this.mobile = mobile;
        this.network = network;
        this.reception = reception;
        recent = new RecentLevels(network.towers().size());
        downlinkLosses = new FrameLosses(network::random);
        uplinkLosses = new FrameLosses(network::random);
    }

    /** The levels of the last measurements. */
    public RecentLevels recent() {
        return recent;
    }

    /** RXQUAL at the last measurement on a channel, 0 to 7. */
    public int quality() {
        return quality;
    }

    /** The mobile's radio link counter. */
    public int count() {
        return downlink.count();
    }

    /** Measurement reports on this channel so far. */
    public int reports() {
        return reports;
    }

    /** The key with which the terminal ciphers. */
    CipherKey key() {
        return key;
    }

    /** Ciphers with the terminal's key. A tower with another one cannot read it, so that the link fails. */
    void cipher(CipherKey newKey) {
        key = newKey;
        if (!isReadable()) {
            LOG.log(
                    Level.WARNING,
                    "{0}: {1} cannot read what is ciphered: the key Kc of the card is not that of the network",
                    mobile,
                    mobile.current());
            network.happened(new MobileEvent.CipherMismatched(mobile, key.algorithm()));
        }
    }

    private boolean isReadable() {
        return mobile.channel().map(channel -> channel.reads(key)).orElse(true);
    }

    /** Restarts the count of blocks on another channel (TS 45.008, 5.2). */
    void moved(BaseStation tower) {
        int timeout = tower.cell().map(cell -> cell.radioLinkTimeout()).orElse(STANDARD_TIMEOUT);
        downlink = new RadioLinkCounter(timeout);
        uplink = new RadioLinkCounter(timeout);
        reports = 0;
        recent.clear();
        measure();
    }

    /** Stores the levels of the last measurement. */
    void measure() {
        double errorRate = reception.errorRate(mobile.serving());
        quality = RadioScale.rxqual(errorRate);
        erasure = ReceptionQuality.frameErasureRate(errorRate);
    }

    boolean losesDownlinkFrame() {
        return loses(downlinkLosses);
    }

    boolean losesUplinkFrame() {
        return loses(uplinkLosses);
    }

    private boolean loses(FrameLosses losses) {
        int arfcn = network.towers().get(mobile.serving()).tower().arfcn();
        return !isReadable()
                || losses.next(erasure, mobile.walker().metresPerSecond(), Frequencies.downlinkMegahertz(arfcn));
    }

    /** Decides randomly if a block from a tower reaches the mobile now. */
    boolean receivesBlock(int tower) {
        double lost = ReceptionQuality.blockErasureRate(reception.errorRate(tower));
        return lost <= 0 || network.random() >= lost;
    }

    /** True if messages get through, with repetitions. */
    boolean isUsable() {
        return isReadable() && ReceptionQuality.blockErasureRate(reception.errorRate(mobile.serving())) < UNUSABLE;
    }

    /**
     * Sends a report and counts the blocks of both directions.
     *
     * @return true if the link has failed
     */
    boolean report(TowerChannel channel) {
        recent.add(reception.levelsDbm());
        int tower = mobile.serving();
        boolean isSent = channel.isActive() && isReadable();
        boolean isUplinkGood = receivesBlock(tower) && isSent;
        boolean isDownlinkGood = receivesBlock(tower) && isSent;
        sendReport(channel, tower, isUplinkGood);
        if (uplink.block(isUplinkGood)) {
            channel.forsake(true);
        }
        return downlink.block(isDownlinkGood);
    }

    private void sendReport(TowerChannel channel, int tower, boolean isReceived) {
        List<Integer> neighbours = reception.neighbours(tower);
        int level = RadioScale.rxlev(reception.levelsDbm()[tower]);
        Optional<MeasurementResults> report =
                isReceived ? Optional.of(reception.report(tower, neighbours)) : Optional.empty();
        int power = MobilePower.used(network.towers().get(tower).tower().arfcn(), channel.orderedPowerLevel());
        int sent = channel.measured(level, quality, power, mobile.timingAdvance(tower), report);
        if (sent >= 0) {
            reports++;
            network.happened(new MobileEvent.Reported(
                    mobile,
                    sent,
                    new MobileEvent.CellLevel(network.nameOf(tower), level),
                    neighbours.stream()
                            .map(each -> new MobileEvent.CellLevel(
                                    network.nameOf(each),
                                    RadioScale.rxlev(reception.levelsDbm()[each])))
                            .toList(),
                    quality,
                    mobile.timingAdvance(tower)));
        }
    }
}
