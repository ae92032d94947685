package simgsm.cells.tower;

import java.lang.System.Logger.Level;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.KeepAlive;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.abis.TowerIdentity;
import simgsm.air.Cause;
import simgsm.air.ChannelNumber;
import simgsm.air.IdentityElements;
import simgsm.air.MobileIdentity;
import simgsm.air.ProtocolViolation;
import simgsm.cells.capture.AirCapture;
import simgsm.cells.cipher.CipherKey;
import simgsm.cells.town.Tower;
import simgsm.event.EventLine;
import simgsm.octets.OctetString;
import simgsm.rr.NeighbourList;
import simgsm.rr.RequestReference;
import simgsm.rr.SystemInformation;
import simgsm.timer.Timers;

/**
 * One tower with one transceiver, as a deterministic core: answers the controller's RSL (TS 48.058) and carries it to the
 * mobiles of its cell. While it is off or without a controller, no mobile hears it.
 *
 * <p>As a line: answer to {@code cells}: on, off, searching (no controller) or refused; free traffic channels.
 */
@EventLine("cell name=tower.name arfcn=tower.arfcn bsic=tower.bsic lac=area x=tower.place.xMetres:1"
        + " y=tower.place.yMetres:1 state= free=freeTrafficChannels")
public final class BaseStation {
    private static final System.Logger LOG = System.getLogger(BaseStation.class.getName());
    private static final int VIOLATIONS_LOGGED = 3;
    private final Tower tower;
    private final int radioLinkTimeout;
    private final Timers timers;
    private final TowerListener listener;
    private final AirInterface air;
    private final AirCapture capture;
    private final KeepAlive keepAlive;
    private final Map<ChannelNumber, TowerChannel> channels = new LinkedHashMap<>();
    private final AccessGrants accesses;
    private Optional<SystemInformation.Type3> cell = Optional.empty();
    private final Map<NeighbourList, List<Integer>> lists = new EnumMap<>(NeighbourList.class);
    private boolean isOn = true;
    /** Null without a connection. */
    private TowerPort port;

    private int violations;
    private boolean isIdentified;
    /** Why the controller refused the last link; empty once in service. */
    private String refusal = "";

    /**
     * Creates a tower that is on, without a controller.
     *
     * @param radioLinkTimeout SACCH blocks, sent to a centre of this suite; osmo-bsc configures its own
     */
    public BaseStation(Tower tower, int radioLinkTimeout, Timers timers, TowerListener listener, AirInterface air) {
        this.tower = tower;
        this.air = air;
        capture =
                new AirCapture(tower.arfcn(), tower.bsic(), () -> FrameClock.frameAt(timers.nowNanos()), air.capture());
        this.radioLinkTimeout = radioLinkTimeout;
        this.timers = timers;
        accesses = new AccessGrants(this, timers);
        this.listener = listener;
        keepAlive = new KeepAlive(timers, this::sendCcm, reason -> {
            if (port != null) {
                port.drop(reason);
            }
        });
        if (capture.isOn()) {
            captureMultiframe();
        }
    }

    public Tower tower() {
        return tower;
    }

    /** The cell's broadcast by the controller; empty before its arrival. */
    public Optional<SystemInformation.Type3> cell() {
        return cell;
    }

    /** The frequencies measured by mobiles in a connection, in the order of their reports. */
    public List<Integer> neighbours() {
        return NeighbourList.inReports(lists);
    }

    public boolean isOn() {
        return isOn;
    }

    /** True if mobiles can use the cell. */
    public boolean isInService() {
        return isOn && port != null && cell.isPresent();
    }

    /** {@code off}, {@code on}, {@code refused} by the controller, or {@code searching} for one. */
    public String state() {
        return !isOn() ? "off" : isInService() ? "on" : refusal.isEmpty() ? "searching" : "refused";
    }

    /** Why the controller refused the last link; empty if it did not. */
    public String refusal() {
        return refusal;
    }

    /** Handles a controller that cannot be reached. */
    public void forgetRefusal() {
        refusal = "";
    }

    private void refused(String reason) {
        if (!reason.equals(refusal)) {
            refusal = reason;
            LOG.log(Level.WARNING, "{0}: refused by the controller: {1}; trying again", this, reason);
            listener.refused(new TowerRefused(tower.name(), reason));
        }
    }

    /** Location area code: the controller's, else the town's. */
    public int area() {
        return cell.map(known -> known.area().areaCode()).orElse(tower.area());
    }

    /** Unused traffic channels of the town's number. */
    public int freeTrafficChannels() {
        long used = channels.values().stream().filter(TowerChannel::isTraffic).count();
        return (int) Math.max(0, tower.trafficChannels() - used);
    }

    public Optional<TowerChannel> channel(ChannelNumber number) {
        return Optional.ofNullable(channels.get(number));
    }

    // The link to the controller.

    /** Connects to the controller. */
    public void connected(TowerPort newPort) {
        port = newPort;
        isIdentified = false;
        keepAlive.start();
        listener.changed(this);
    }

    private void captureMultiframe() {
        if (isInService()) {
            capture.multiframe();
        }
        timers.start(FrameClock.untilMultiframeNanos(timers.nowNanos()), this::captureMultiframe);
    }

    /** Handles the loss of the connection. One that ends after the unit id without a reason is that of osmo-bsc. */
    public void disconnected() {
        if (isOn && isIdentified && cell.isEmpty() && refusal.isEmpty()) {
            refused("unit id " + tower.unitId() + " is not configured there, or has no OML link yet");
        }
        port = null;
        keepAlive.stop();
        cell = Optional.empty();
        lists.clear();
        clear();
        listener.changed(this);
    }

    /** Switches the transmitter and the link, as with the power of the site. */
    public void switchTo(boolean on) {
        if (on != isOn) {
            isOn = on;
            if (!on) {
                clear();
                if (port != null) {
                    port.drop("the tower is switched off");
                }
            }
            listener.changed(this);
        }
    }

    private void clear() {
        List<TowerChannel> lost = List.copyOf(channels.values());
        channels.clear();
        accesses.clear();
        lost.forEach(TowerChannel::close);
    }

    /** Handles a frame of the controller. */
    public void frameArrived(IpaFrame frame) {
        keepAlive.heard();
        try {
            switch (frame.stream()) {
                case IpaFrame.RSL -> arrived(RslPdu.decode(frame.payload()));
                case IpaFrame.CCM -> arrived(CcmCodec.decode(frame.payload()));
                default -> LOG.log(Level.DEBUG, "{0}: a frame of stream {1} dropped", this, frame.stream());
            }
        } catch (ProtocolViolation e) {
            violated(e.getMessage());
            if (frame.stream() == IpaFrame.RSL) {
                RslErrors.report(e.statusCause(), frame.payload()).ifPresent(this::send);
            }
        }
    }

    private void violated(String what) {
        violations++;
        LOG.log(violations <= VIOLATIONS_LOGGED ? Level.WARNING : Level.DEBUG, "{0}: {1}", this, what);
    }

    private void arrived(CcmMessage message) {
        if (message instanceof CcmMessage.IdentityRequest) {
            sendCcm(identity().response());
            sendCcm(new CcmMessage.IdentityAcknowledge());
            isIdentified = true;
        } else if (message instanceof CcmMessage.IdentityResponse reason) {
            refused(reason.unitName());
        } else {
            keepAlive.receive(message);
        }
    }

    private TowerIdentity identity() {
        return new TowerIdentity(
                tower.unitId(),
                tower.name(),
                tower.arfcn(),
                tower.bsic(),
                tower.area(),
                tower.cellIdentity(),
                tower.trafficChannels(),
                radioLinkTimeout,
                tower.selection().accessMinimumRxlev(),
                tower.selection().hysteresisDecibels());
    }

    private void sendCcm(CcmMessage message) {
        if (port != null) {
            port.send(new IpaFrame(IpaFrame.CCM, CcmCodec.encode(message)));
        }
    }

    void send(RslPdu message) {
        if (port != null) {
            port.send(new IpaFrame(IpaFrame.RSL, message.encode()));
        }
    }

    CipherKey cipherKey(RslPdu message) throws ProtocolViolation {
        return CipherKey.of(message, air.algorithms());
    }

    AirCapture capture() {
        return capture;
    }

    TowerPort port() {
        return port;
    }

    private void arrived(RslPdu message) throws ProtocolViolation {
        switch (message.type()) {
            case BCCH_INFORMATION -> {
                if (message.has(RslElement.FULL_BCCH_INFORMATION)) {
                    capture.broadcast(message.value(RslElement.FULL_BCCH_INFORMATION));
                    informed(message.value(RslElement.FULL_BCCH_INFORMATION));
                }
            }
            case SACCH_FILLING -> {
                if (message.has(RslElement.L3_INFORMATION)) {
                    capture.slow(message.value(RslElement.L3_INFORMATION));
                    informed(message.value(RslElement.L3_INFORMATION));
                } else {
                    int type = message.octet(RslElement.SYSTEM_INFORMATION_TYPE);
                    lists.keySet().removeIf(list -> list.informationType() == type);
                }
            }
            case MEASUREMENT_PREPROCESSING_DEFAULTS, SACCH_INFORMATION_MODIFY, RF_RESOURCE_INDICATION -> {}
            case CHANNEL_ACTIVATION -> activate(message);
            case IMMEDIATE_ASSIGN_COMMAND -> accesses.answer(message.value(RslElement.FULL_IMMEDIATE_ASSIGN));
            case PAGING_COMMAND -> page(message);
            case SMS_BROADCAST_COMMAND -> listener.broadcast(this, message.value(RslElement.BROADCAST_MESSAGE));
            default -> toChannel(message);
        }
    }

    private void informed(OctetString octets) throws ProtocolViolation {
        SystemInformation information = SystemInformation.decode(octets).orElse(null);
        if (information instanceof SystemInformation.Type3 type3) {
            if (cell.isEmpty()) {
                LOG.log(
                        Level.INFO,
                        "{0}: in service, location area {1}",
                        this,
                        Integer.toString(type3.area().areaCode()));
            }
            cell = Optional.of(type3);
            refusal = "";
            listener.changed(this);
        } else if (information instanceof SystemInformation.Neighbours neighbours) {
            lists.put(neighbours.list(), neighbours.arfcns());
        }
    }

    private void activate(RslPdu message) throws ProtocolViolation {
        ChannelNumber number = message.channel();
        if (channels.containsKey(number)) {
            refuse(number, RslErrors.CHANNEL_ACTIVATED);
            return;
        }
        try {
            channels.put(number, new TowerChannel(this, timers, message));
        } catch (ProtocolViolation e) {
            violated(e.getMessage());
            refuse(number, RslErrors.cause(e.statusCause()));
            return;
        }
        send(RslPdu.of(RslType.CHANNEL_ACTIVATION_ACKNOWLEDGE, number).with(RslElement.FRAME_NUMBER, frameOctets()));
    }

    private void refuse(ChannelNumber number, int cause) {
        send(RslPdu.of(RslType.CHANNEL_ACTIVATION_NEGATIVE_ACKNOWLEDGE, number).with(RslElement.CAUSE, cause));
    }

    private OctetString frameOctets() {
        int frame =
                RequestReference.at(0, FrameClock.frameAt(timers.nowNanos())).frame();
        return OctetString.of(new byte[] {(byte) (frame >> 8), (byte) frame});
    }

    private void page(RslPdu message) throws ProtocolViolation {
        int group = message.octet(RslElement.PAGING_GROUP);
        MobileIdentity identity = IdentityElements.read(message.reader(RslElement.MOBILE_IDENTITY));
        if (cell.isPresent()) {
            var control = cell.get().control();
            timers.start(
                    FrameClock.untilPagingNanos(
                            timers.nowNanos(), group, control.pagingBlocks(), control.pagingMultiframes()),
                    () -> {
                        if (isInService()) {
                            capture.page(control.blocksForAccessGrant() + group % control.pagingBlocks(), identity);
                            listener.paged(this, group, identity);
                        }
                    });
        }
    }

    private void toChannel(RslPdu message) throws ProtocolViolation {
        ChannelNumber number = message.channel();
        TowerChannel channel = channels.get(number);
        if (channel != null) {
            channel.arrived(message);
        } else if (message.type() == RslType.RF_CHANNEL_RELEASE) {
            send(RslPdu.of(RslType.RF_CHANNEL_RELEASE_ACKNOWLEDGE, number));
        } else {
            throw new ProtocolViolation(
                    Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE,
                    message.type().title() + " for " + number + ", which is not active");
        }
    }

    /** Handles the controller's release of the channel. */
    void released(TowerChannel channel) {
        channels.remove(channel.number());
        send(RslPdu.of(RslType.RF_CHANNEL_RELEASE_ACKNOWLEDGE, channel.number()));
    }

    /** The common channels of the mobiles' accesses. */
    public AccessGrants accesses() {
        return accesses;
    }

    @Override
    public String toString() {
        return "tower " + tower.name();
    }
}
