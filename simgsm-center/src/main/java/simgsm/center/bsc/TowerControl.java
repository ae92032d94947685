package simgsm.center.bsc;

import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ChannelNumber;
import simgsm.air.ChannelNumber.Kind;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.MeasurementResults;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.center.bsc.handover.Measurement;
import simgsm.center.bsc.handover.NeighbourCell;
import simgsm.center.msc.link.Lifeline;
import simgsm.center.msc.link.Peer;
import simgsm.center.msc.link.PeerUser;
import simgsm.octets.OctetString;
import simgsm.rr.ImmediateAssignment;
import simgsm.rr.ImmediateAssignmentReject;
import simgsm.rr.NeighbourList;
import simgsm.timer.Timers;

/** One tower: its link, its system information, its channels. */
final class TowerControl implements PeerUser, Lifeline {
    private static final System.Logger LOG = System.getLogger(TowerControl.class.getName());

    /** Number of protocol errors after which the link is closed. */
    private static final int MAX_VIOLATIONS = 100;

    /** Number of protocol errors, and of the tower's error reports, that are logged as warnings. */
    private static final int MAX_LOGGED = 3;

    /** Minimum age of a link that a tower with the same unit id may replace. */
    private static final long LEAST_CONNECTION_NANOS = TimeUnit.SECONDS.toNanos(10);

    private static final ChannelNumber BCCH = ChannelNumber.of(Kind.BCCH, 0);
    private static final ChannelNumber AGCH = ChannelNumber.of(Kind.PCH_AGCH, 0);

    /** System information type of SACCH FILLING (TS 48.058, 9.3.30). */
    private static final int TYPE_6 = 0x06;
    /** Messages replaced by their layer 3 in the ladder, and measurements, which are too frequent. */
    private static final Set<RslType> UNTRACED = EnumSet.of(
            RslType.DATA_REQUEST,
            RslType.DATA_INDICATION,
            RslType.ESTABLISH_INDICATION,
            RslType.MEASUREMENT_RESULT,
            RslType.RF_RESOURCE_INDICATION);

    private final BaseStationController controller;
    private final Peer peer;
    private final String unitId;
    private final long connectedNanos;
    private final TowerPlan plan;
    private final Timers timers;
    private final Map<ChannelNumber, DedicatedChannel> channels = new HashMap<>();
    private final List<DedicatedChannel> inOrder = new ArrayList<>();
    /** Connections in the order of their waits. */
    private final List<RadioConnection> queue = new ArrayList<>();

    private NeighbourFrequencies neighbours = NeighbourFrequencies.NONE;
    private int violations;
    private int errorReports;
    private boolean isClosed;

    TowerControl(BaseStationController controller, Peer peer, String unitId, TowerPlan plan) {
        this.controller = controller;
        this.peer = peer;
        this.unitId = unitId;
        this.plan = plan;
        this.timers = controller.timers().ownedBy(this::failed);
        this.connectedNanos = timers.nowNanos();
        for (ChannelNumber number : plan.channels()) {
            DedicatedChannel channel = new DedicatedChannel(this, number);
            channels.put(number, channel);
            inOrder.add(channel);
        }
    }

    String unitId() {
        return unitId;
    }

    TowerPlan plan() {
        return plan;
    }

    CellSettings settings() {
        return controller.settings();
    }

    Timers timers() {
        return timers;
    }

    String address() {
        return peer.address();
    }

    boolean isLocal() {
        return peer.isLocal();
    }

    MediaPort openMedia(Consumer<byte[]> received) {
        return peer.port().newMedia(received);
    }

    // System information.

    /** Sends the whole system information. */
    void start() {
        SystemInformationBlocks blocks = blocks();
        send(1, false, blocks.type1());
        sendLists(false);
        send(3, false, blocks.type3());
        send(4, false, blocks.type4());
        sendLists(true);
        send(TYPE_6, true, blocks.type6());
    }

    /** Sets the other cells. */
    void setNeighbours(NeighbourFrequencies frequencies, boolean isTold) {
        Set<NeighbourList> ended = blocks().lists().keySet();
        boolean isChanged = !frequencies.equals(neighbours);
        neighbours = frequencies;
        if (isChanged && isTold) {
            sendLists(false);
            sendLists(true);
            ended.removeAll(blocks().lists().keySet());
            ended.forEach(list -> send(information(list.isDedicated(), list.informationType())));
        }
    }

    private SystemInformationBlocks blocks() {
        return new SystemInformationBlocks(plan, neighbours, settings());
    }

    private void sendLists(boolean isDedicated) {
        blocks().lists().forEach((list, block) -> {
            if (list.isDedicated() == isDedicated) {
                send(list.informationType(), isDedicated, block);
            }
        });
    }

    private void send(int type, boolean isDedicated, OctetString block) {
        send(information(isDedicated, type)
                .with(isDedicated ? RslElement.L3_INFORMATION : RslElement.FULL_BCCH_INFORMATION, block));
    }

    /** SACCH FILLING or BCCH INFORMATION; without a block it ends the broadcast. */
    private static RslPdu information(boolean isDedicated, int type) {
        RslPdu message = isDedicated ? RslPdu.of(RslType.SACCH_FILLING) : RslPdu.of(RslType.BCCH_INFORMATION, BCCH);
        return message.with(RslElement.SYSTEM_INFORMATION_TYPE, type);
    }

    // Channels.

    private Optional<DedicatedChannel> free(boolean isSpeech) {
        return inOrder.stream()
                .filter(channel -> channel.number().kind().isSpeech() == isSpeech && channel.isFree())
                .findFirst();
    }

    Optional<DedicatedChannel> freeTrafficChannel() {
        return isClosed ? Optional.empty() : free(true);
    }

    /** Number of free channels. */
    long freeChannels() {
        return inOrder.stream().filter(DedicatedChannel::isFree).count();
    }

    /** Adds a connection to the queue for a traffic channel. */
    void queue(RadioConnection connection) {
        queue.remove(connection);
        queue.add(connection);
        queue.sort(Comparator.comparingLong(RadioConnection::waitingSinceNanos));
    }

    /** Removes a connection from the queue. */
    void unqueue(RadioConnection connection) {
        queue.remove(connection);
    }

    /** Serves waiting connections after the release of a channel. */
    void freed() {
        while (!queue.isEmpty() && freeTrafficChannel().isPresent()) {
            queue.remove(0).seekSpeech();
        }
    }

    /** Assigns an SDCCH to a request, else a traffic channel for signalling, else rejects it. */
    private void request(RslPdu message) throws ProtocolViolation {
        ChannelRequest request = ChannelRequest.of(message);
        Optional<DedicatedChannel> channel = free(false).or(() -> free(true));
        if (channel.isPresent()) {
            RadioConnection.begin(controller, request, channel.get());
        } else {
            reject(request);
        }
    }

    void grant(ChannelRequest request, DedicatedChannel channel) {
        sendAccessGrant(
                new ImmediateAssignment(channel.description(), request.reference(), request.accessDelay()).encode());
    }

    void reject(ChannelRequest request) {
        sendAccessGrant(new ImmediateAssignmentReject(List.of(request.reference()), BscTimer.T3122.seconds()).encode());
    }

    private void sendAccessGrant(OctetString block) {
        send(RslPdu.of(RslType.IMMEDIATE_ASSIGN_COMMAND, AGCH).with(RslElement.FULL_IMMEDIATE_ASSIGN, block));
    }

    // Messages.

    void send(RslPdu message) {
        if (!isClosed) {
            byte[] octets = message.encode();
            trace(Direction.DOWNLINK, message.type(), octets);
            peer.port().send(new IpaFrame(IpaFrame.RSL, octets));
        }
    }

    private void trace(Direction direction, RslType type, byte[] octets) {
        if (!UNTRACED.contains(type)) {
            controller.links().trace().passed(this, direction, type.title(), OctetString.of(octets));
        }
    }

    @Override
    public void received(IpaFrame frame) throws ProtocolViolation {
        if (frame.stream() == IpaFrame.RSL) {
            RslPdu message = RslPdu.decode(frame.payload());
            trace(Direction.UPLINK, message.type(), frame.payload());
            receive(message);
        } else {
            violated("sent a frame of unknown stream " + frame.stream());
        }
    }

    private void receive(RslPdu message) throws ProtocolViolation {
        switch (message.type()) {
            case CHANNEL_REQUIRED -> request(message);
            case CCCH_LOAD_INDICATION, CBCH_LOAD_INDICATION, RF_RESOURCE_INDICATION, DELETE_INDICATION, OVERLOAD ->
                LOG.log(Level.TRACE, "{0}: {1}", this, message.type().title());
            case ERROR_REPORT -> LOG.log(levelOf(++errorReports), "{0}: reports an error: {1}", this, message);
            default -> {
                DedicatedChannel channel = channels.get(message.channel());
                if (channel == null) {
                    violated("has no " + message.channel());
                } else {
                    channel.receive(message);
                }
            }
        }
    }

    /** Decodes a MEASUREMENT RESULT; ignores neighbours on frequencies that the cell does not list. */
    Measurement measurement(RslPdu message) throws ProtocolViolation {
        int number = message.octet(RslElement.MEASUREMENT_RESULT_NUMBER);
        boolean usesDtx = (message.octet(RslElement.UPLINK_MEASUREMENTS) & 0x40) != 0;
        int reduction = 2
                * (message.find(RslElement.BS_POWER)
                                .map(power -> power.octet(0))
                                .orElse(0)
                        & 0x0f);
        int timingAdvance =
                message.find(RslElement.L1_INFORMATION).map(l1 -> l1.octet(1)).orElse(0);
        Optional<MeasurementResults> report =
                message.find(RslElement.L3_INFORMATION).flatMap(TowerControl::reportIn);
        if (report.isEmpty()) {
            return new Measurement(number, false, 0, 0, 0, timingAdvance, List.of());
        }
        MeasurementResults results = report.get();
        List<Integer> listed = neighbours.inReports();
        return new Measurement(
                number,
                results.isValid(),
                results.fullLevel(),
                (usesDtx ? results.subLevel() : results.fullLevel()) + reduction,
                usesDtx ? results.subQuality() : results.fullQuality(),
                timingAdvance,
                results.neighbours().stream()
                        .filter(each -> each.frequencyIndex() < listed.size())
                        .map(each -> new Measurement.Neighbour(
                                new NeighbourCell(listed.get(each.frequencyIndex()), each.identityCode()),
                                each.level()))
                        .toList());
    }

    /** The mobile's report; an invalid one counts as missing, because it is not the tower's fault. */
    private static Optional<MeasurementResults> reportIn(OctetString layer3) {
        try {
            return Layer3Codec.decode(layer3.toArray(), Direction.UPLINK)
                            instanceof RadioResource.MeasurementReport report
                    ? Optional.of(report.results())
                    : Optional.empty();
        } catch (ProtocolViolation unreadable) {
            return Optional.empty();
        }
    }

    // The link.

    @Override
    public void violated(String what) {
        violations++;
        LOG.log(levelOf(violations), "{0}: {1}", this, what);
        if (violations == MAX_VIOLATIONS) {
            peer.drop(MAX_VIOLATIONS + " protocol errors");
        }
    }

    private static Level levelOf(int count) {
        return count <= MAX_LOGGED ? Level.WARNING : Level.DEBUG;
    }

    @Override
    public void failed(RuntimeException e) {
        LOG.log(Level.ERROR, this + ": closed after an error of our own", e);
        peer.drop("internal error");
    }

    /**
     * Checks if another link may replace this one of the same tower.
     *
     * @throws IllegalArgumentException if it may not
     */
    void checkReplaceable(Peer newcomer) {
        if (!newcomer.host().equals(peer.host()) && !peer.isSilent()) {
            throw new IllegalArgumentException("unit id " + unitId + " is in use from " + peer.host());
        }
        if (timers.nowNanos() - connectedNanos < LEAST_CONNECTION_NANOS) {
            throw new IllegalArgumentException("unit id " + unitId + " was connected less than 10 s ago");
        }
    }

    void replace() {
        peer.drop("the tower has connected again");
    }

    @Override
    public boolean isKnown() {
        return true;
    }

    @Override
    public void closed() {
        isClosed = true;
        Collection<DedicatedChannel> all = List.copyOf(inOrder);
        all.forEach(DedicatedChannel::lost);
        controller.towerLost(this);
    }

    @Override
    public String lifeline() {
        return plan.name();
    }

    @Override
    public boolean hasNumber() {
        return true;
    }

    /** The name. */
    @Override
    public String toString() {
        return plan.name();
    }
}
