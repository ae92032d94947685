package simgsm.center.bsc;

import java.lang.System.Logger.Level;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Predicate;
import simgsm.abis.CcmMessage;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ChannelNumber;
import simgsm.air.Direction;
import simgsm.air.IdentityElements;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.bsc.handover.NeighbourCell;
import simgsm.center.msc.link.BroadcastChannel;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.MobileUplink;
import simgsm.center.msc.link.Peer;
import simgsm.center.msc.link.PeerUser;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.timer.Timers;

/**
 * The base station controller: the towers and their mobiles. To the towers it speaks RSL like osmo-bsc; to the exchange
 * each mobile is a {@link Link} like a terminal's with its own cell.
 */
public final class BaseStationController implements BroadcastChannel {
    private static final System.Logger LOG = System.getLogger(BaseStationController.class.getName());

    private static final ChannelNumber PCH = ChannelNumber.of(ChannelNumber.Kind.PCH_AGCH, 0);
    /**
     * Number of paging groups with combined common channels: 3 blocks less one for access grant, in each of 5
     * multiframes (TS 45.002, 6.5).
     */
    private static final int PAGING_GROUPS = 10;

    private static final int IMSI_MODULUS = 1_000;
    private static final int HANDOVER_REFERENCES = 256;

    private final Link.Context links;
    private final MobileUplink uplink;
    private CellSettings settings;
    private final Function<MobileIdentity, Optional<Link>> known;
    private final Predicate<Link> mustProve;
    private final Map<String, TowerControl> towers = new LinkedHashMap<>();
    private int handoverReference;
    private String lastRefusal = "";

    /**
     * @param links context of all links
     * @param uplink receives the mobiles' messages
     * @param known finds the link of a registered subscriber
     * @param mustProve true if a mobile that names the subscriber of this link has to prove it first
     */
    public BaseStationController(
            Link.Context links,
            MobileUplink uplink,
            CellSettings settings,
            Function<MobileIdentity, Optional<Link>> known,
            Predicate<Link> mustProve) {
        this.links = links;
        this.uplink = uplink;
        this.settings = settings;
        this.known = known;
        this.mustProve = mustProve;
    }

    /**
     * Accepts a peer as a tower. It replaces an older link with its unit id, as in osmo-bsc, if that is from the same
     * host or silent, and at least 10 s old.
     *
     * @throws IllegalArgumentException if it conflicts with the others, which remain
     */
    public PeerUser towerConnected(Peer peer, CcmMessage.IdentityResponse identity) {
        try {
            return admit(peer, identity);
        } catch (IllegalArgumentException e) {
            String refusal = identity.unitId() + " is refused: " + e.getMessage();
            LOG.log(refusal.equals(lastRefusal) ? Level.DEBUG : Level.WARNING, "tower {0}", refusal);
            lastRefusal = refusal;
            throw e;
        }
    }

    private TowerControl admit(Peer peer, CcmMessage.IdentityResponse identity) {
        TowerControl old = towers.get(identity.unitId());
        if (old != null) {
            old.checkReplaceable(peer);
        }
        List<TowerControl> others =
                towers.values().stream().filter(tower -> tower != old).toList();
        TowerPlan plan = planOf(identity, others);
        checkFrequencies(plan, others);
        if (old != null) {
            old.replace();
        }
        TowerControl tower = new TowerControl(this, peer, identity.unitId(), plan);
        towers.put(identity.unitId(), tower);
        LOG.log(
                Level.INFO,
                "tower {0} ({1}): {2}, location area {3,number,#}",
                tower,
                identity.unitId(),
                tower.plan().cell(),
                tower.plan().area().areaCode());
        listNeighbours(tower);
        tower.start();
        return tower;
    }

    /** The parameters sent by the tower; the rest from the first position with an unused cell. */
    private static TowerPlan planOf(CcmMessage.IdentityResponse identity, List<TowerControl> others) {
        TowerPlan plan = TowerPlan.of(identity, 0);
        for (int position = 1; position <= others.size() && isUsed(plan.cell(), others); position++) {
            plan = TowerPlan.of(identity, position);
        }
        return plan;
    }

    private static boolean isUsed(RadioResource.CellDescription cell, List<TowerControl> others) {
        return others.stream().anyMatch(tower -> tower.plan().cell().equals(cell));
    }

    /** Checks that the lists of each cell have room for all others. */
    private static void checkFrequencies(TowerPlan newcomer, List<TowerControl> others) {
        Set<Integer> frequencies = new TreeSet<>(Set.of(newcomer.cell().frequency()));
        others.forEach(tower -> frequencies.add(tower.plan().cell().frequency()));
        frequencies.forEach(own -> NeighbourFrequencies.of(own, frequencies));
    }

    void towerLost(TowerControl tower) {
        if (towers.remove(tower.unitId(), tower)) {
            listNeighbours(null);
        }
    }

    /**
     * Updates the neighbours of each cell.
     *
     * @param newcomer has not received its list yet
     */
    private void listNeighbours(TowerControl newcomer) {
        for (TowerControl tower : List.copyOf(towers.values())) {
            List<Integer> others = towers.values().stream()
                    .filter(other -> other != tower)
                    .map(other -> other.plan().cell().frequency())
                    .toList();
            tower.setNeighbours(NeighbourFrequencies.of(tower.plan().cell().frequency(), others), tower != newcomer);
        }
    }

    Link.Context links() {
        return links;
    }

    Timers timers() {
        return links.timers();
    }

    MobileUplink uplink() {
        return uplink;
    }

    /** Sets the algorithm from the next traffic channel on. */
    public void setHandover(HandoverAlgorithm handover) {
        settings = new CellSettings(settings.t3212SixMinutes(), handover);
    }

    CellSettings settings() {
        return settings;
    }

    /** The tower of this cell. */
    Optional<TowerControl> tower(NeighbourCell cell) {
        return towers.values().stream()
                .filter(tower -> tower.plan().cell().frequency() == cell.frequency()
                        && tower.plan().cell().identityCode() == cell.identityCode())
                .findFirst();
    }

    int nextHandoverReference() {
        handoverReference = (handoverReference + 1) % HANDOVER_REFERENCES;
        return handoverReference;
    }

    /**
     * The mobile of this first message; a new one for a location update, an unknown mobile, and one that has to prove
     * its identity.
     */
    TowerMobile mobileOf(OctetString firstMessage, TowerControl tower) {
        return identityIn(firstMessage)
                .flatMap(known)
                .filter(mustProve.negate())
                .map(Link::access)
                .filter(TowerMobile.class::isInstance)
                .map(TowerMobile.class::cast)
                .orElseGet(() -> new TowerMobile(this, tower));
    }

    private static Optional<MobileIdentity> identityIn(OctetString firstMessage) {
        try {
            Layer3Message message = Layer3Codec.decode(firstMessage.toArray(), Direction.UPLINK);
            if (message instanceof MobilityManagement.CmServiceRequest request) {
                return Optional.of(request.identity());
            }
            if (message instanceof MobilityManagement.ImsiDetachIndication indication) {
                return Optional.of(indication.identity());
            }
            return message instanceof RadioResource.PagingResponse response
                    ? Optional.of(response.identity())
                    : Optional.empty();
        } catch (ProtocolViolation violation) {
            return Optional.empty();
        }
    }

    /** Pages a mobile once in all cells of its location area. */
    void page(Link mobile, LocationArea area, MobileIdentity identity) {
        OctetWriter octets = new OctetWriter();
        IdentityElements.write(octets, identity);
        long imsi = Long.parseLong(mobile.subscriber().imsi().digits());
        RslPdu message = RslPdu.of(RslType.PAGING_COMMAND, PCH)
                .with(RslElement.PAGING_GROUP, (int) (imsi % IMSI_MODULUS % PAGING_GROUPS))
                .with(RslElement.MOBILE_IDENTITY, octets.toOctetString())
                .with(RslElement.CHANNEL_NEEDED, 0);
        in(area).forEach(tower -> tower.send(message));
    }

    private Collection<TowerControl> in(LocationArea area) {
        return towers.values().stream()
                .filter(tower -> tower.plan().area().equals(area))
                .toList();
    }

    @Override
    public void broadcast(OctetString page) {
        RslPdu message = RslPdu.of(RslType.SMS_BROADCAST_COMMAND, PCH)
                .with(RslElement.BROADCAST_COMMAND_TYPE, 0)
                .with(RslElement.BROADCAST_MESSAGE, page);
        towers.values().forEach(tower -> tower.send(message));
    }

    /** Connected towers with the number of their free channels. */
    public Map<String, Long> freeChannels() {
        Map<String, Long> free = new LinkedHashMap<>();
        towers.values().forEach(tower -> free.put(tower.toString(), tower.freeChannels()));
        return free;
    }
}
