package simgsm.cells.mobile;

import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.OptionalInt;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.abis.RslMessage.Sapi;
import simgsm.air.CipherAlgorithm;
import simgsm.air.MobileIdentity;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.cells.cipher.CipherKey;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioAction;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioEvent;
import simgsm.cells.mobile.MobileRadioTable.MobileRadioState;
import simgsm.cells.snapshot.PassingStep;
import simgsm.cells.tower.BaseStation;
import simgsm.cells.tower.ChannelUser;
import simgsm.cells.tower.TowerChannel;
import simgsm.cells.town.TownPlace;
import simgsm.octets.OctetString;
import simgsm.rr.ImmediateAssignment;
import simgsm.state.StateMachine;
import simgsm.timer.Timers;

/**
 * One terminal and the radio part that it lacks, as a deterministic core: frames of the terminal, messages of its tower
 * and time in; frames to both out. The terminal's layer 3 waits while the mobile changes channels or its signal is too
 * weak.
 */
public final class Mobile {
    /** Period of measurements and of blocks of the slow associated channel: 480 ms. */
    public static final long PERIOD_NANOS = 480_000_000L;

    private static final System.Logger LOG = System.getLogger(Mobile.class.getName());
    /** Time to leave a channel's link layer and to find the common channels again. */
    private static final long RETURN_NANOS = 500_000_000L;

    private static final int ABNORMAL_RELEASE = 1;

    private final MobilePort port;
    private final MobileNetwork network;
    private final Timers timers;
    private final Walker walker;
    private final Reception reception;
    private final IdleSelection selection;
    private final SubscriberIdentity identity = new SubscriberIdentity();
    private final ChannelRequests requests;
    private final MobileSpeech speech;
    private final RadioLink link;
    private final ChannelChange change;
    private final MeasurementCycle measurements;
    private final StateMachine<MobileRadioState, MobileRadioEvent, MobileRadioAction> machine;
    private final HeldLayer3 held = new HeldLayer3(
            this::isReachable, data -> channel().orElseThrow().send(data.sapi().code(), data.layer3()), this::pass);
    private final Receiver receiver = new Receiver();
    private final String address;
    /** The first message of a connection being opened; null otherwise. */
    private OctetString firstMessage;
    /** Null without a channel. */
    private TowerChannel channel;

    private ImmediateAssignment granted;
    /** Time of the return to idle mode after the last channel. */
    private long idleNanos;

    /** Receives the tower's answers. */
    private final class Receiver implements ChannelUser, ChannelRequests.Outcome {
        @Override
        public void granted(ImmediateAssignment assignment) {
            granted = assignment;
            machine.fire(MobileRadioEvent.GRANTED);
        }

        @Override
        public void failed() {
            machine.fire(MobileRadioEvent.ACCESS_FAILED);
        }

        @Override
        public void layer3Arrived(TowerChannel from, int sapi, OctetString layer3) {
            if (from == channel) {
                held.add(new RslMessage.DataRequest(sapi == 0 ? Sapi.SIGNALLING : Sapi.SHORT_MESSAGES, layer3));
            }
        }

        @Override
        public void speechArrived(TowerChannel from, byte[] rtp) {
            if (from == channel && machine.state() == MobileRadioState.DEDICATED && !link.losesDownlinkFrame()) {
                speech.deliver(rtp);
            }
        }

        @Override
        public void physicalInformation(TowerChannel from, int timingAdvance) {
            change.physicalInformation(from, timingAdvance);
        }

        @Override
        public CipherKey key() {
            return link.key();
        }

        @Override
        public void ciphered(CipherAlgorithm algorithm) {
            network.happened(new MobileEvent.Ciphered(Mobile.this, algorithm));
        }

        @Override
        public void channelLost(TowerChannel lost) {
            // the mobile notices the loss of its channel only by the radio link counter
            if (lost != channel) {
                change.lost(lost);
            }
        }
    }

    /** Creates the mobile of a newly connected terminal. */
    public Mobile(MobilePort port, String address, MobileNetwork network, Timers timers, TownPlace place) {
        this.port = port;
        this.address = address;
        this.network = network;
        this.timers = timers;
        walker = new Walker(place);
        reception = new Reception(network);
        link = new RadioLink(this, network, reception);
        selection = new IdleSelection(network.towers().size());
        requests = new ChannelRequests(network, timers, receiver);
        speech = new MobileSpeech(port, timers, millis -> network.happened(new MobileEvent.SpeechGap(this, millis)));
        change = new ChannelChange(this, network, timers);
        machine = new StateMachine<>(MobileRadioTable.TABLE, address, this::perform);
        measurements = new MeasurementCycle(this, network, timers, reception, new CellNotice(this::send));
    }

    /** The number; while it is unknown, the equipment's identity or the terminal's address. */
    public String number() {
        return identity.number().orElse(address);
    }

    public Walker walker() {
        return walker;
    }

    public MobileRadioState state() {
        return machine.state();
    }

    /** The index of the serving tower; {@link IdleSelection#NONE} for none. */
    public int serving() {
        return channel == null ? selection.serving() : network.towers().indexOf(channel.tower());
    }

    /** The name of the serving tower; empty for none. */
    public String cell() {
        return network.nameOf(serving());
    }

    public Optional<TowerChannel> channel() {
        return Optional.ofNullable(channel);
    }

    public IdleSelection selection() {
        return selection;
    }

    /** The levels of all towers at the last measurement, in dBm. */
    public double[] levelsDbm() {
        return reception.levelsDbm().clone();
    }

    /** Reception on the current or last channel. */
    public RadioLink link() {
        return link;
    }

    /** The silence during the last handover. */
    public OptionalInt gapMillis() {
        return speech.gapMillis();
    }

    // From the terminal.

    /** A message of the terminal. */
    public void arrived(RslMessage message) throws ProtocolViolation {
        if (message instanceof RslMessage.EncryptionCommand command) {
            link.cipher(CipherKey.of(command.pdu(), network.algorithms()));
        } else if (message instanceof RslMessage.EstablishIndication establish) {
            machine.fire(MobileRadioEvent.LEFT);
            firstMessage = read(establish.layer3());
            machine.fire(MobileRadioEvent.FIRST_MESSAGE);
        } else if (message instanceof RslMessage.DataIndication data) {
            held.add(new RslMessage.DataIndication(data.sapi(), read(data.layer3())));
        } else if (message instanceof RslMessage.ReleaseIndication) {
            machine.fire(MobileRadioEvent.LEFT);
        }
    }

    /** Reads a message. @return it with the classmark of the mobile's radio */
    private OctetString read(OctetString layer3) {
        if (identity.readUplink(layer3)) {
            network.identified(this);
            measurements.measure();
        }
        return RadioClassmark.in(layer3, network.algorithms());
    }

    /** An RTP packet of the terminal. */
    public void speechArrived(byte[] rtp) throws ProtocolViolation {
        if (machine.state() == MobileRadioState.DEDICATED && channel.isTraffic() && !link.losesUplinkFrame()) {
            channel.sendSpeech(speech.convert(rtp));
        }
    }

    /** Closes the terminal's connection, as without a network: the terminal reports it, reconnects and registers. */
    public void letGo(String reason) {
        port.close(reason);
    }

    /** Handles the end of the terminal's connection. */
    public void close() {
        measurements.stop();
        machine.fire(MobileRadioEvent.TERMINAL_LOST);
    }

    // From the tower.

    /** PAGING REQUEST in a group's block. */
    public void paged(int tower, int group, int groups, MobileIdentity paged) {
        if (machine.state() == MobileRadioState.IDLE
                && selection.serving() == tower
                && identity.isPaged(paged, group, groups)) {
            passed(PassingStep.Kind.PAGING, cell(), "", 0);
            send(new RslMessage.PagingCommand(paged));
        }
    }

    /** A page of cell broadcast. */
    public void broadcast(int tower, OctetString page) {
        if (serving() == tower && page.length() == RslMessage.SmsBroadcastCommand.PAGE_LENGTH) {
            send(new RslMessage.SmsBroadcastCommand(page));
        }
    }

    private void send(RslMessage message) {
        port.send(new IpaFrame(IpaFrame.RSL, message.encode()));
    }

    // Actions of the state machine.

    private void perform(MobileRadioAction action) {
        switch (action) {
            case REQUEST_CHANNEL -> requestChannel();
            case END_ACCESS -> requests.end();
            case ESTABLISH -> establish();
            case BEGIN_ASSIGNMENT -> change.beginAssignment();
            case COMPLETE_ASSIGNMENT -> change.completeAssignment();
            case FAIL_ASSIGNMENT -> change.failAssignment();
            case BEGIN_HANDOVER -> change.beginHandover();
            case COMPLETE_HANDOVER -> change.completeHandover();
            case FAIL_HANDOVER -> change.failHandover();
            case SEND_HELD -> held.pass();
            case LEAVE_CHANNEL -> {
                held.passUp();
                channel.leave();
            }
            case FORSAKE_CHANNEL -> forsake();
            case RELEASE_TERMINAL ->
                send(new RslMessage.DataRequest(
                        Sapi.SIGNALLING, ChannelChange.encoded(new RadioResource.ChannelRelease(ABNORMAL_RELEASE))));
            case FORGET -> forget();
        }
    }

    private void requestChannel() {
        int tower = selection.serving();
        if (tower == IdleSelection.NONE || !network.towers().get(tower).isInService()) {
            if (!network.isInService() || !EstablishmentCause.waitsForCell(firstMessage)) {
                machine.fire(MobileRadioEvent.ACCESS_FAILED);
            }
            // out of coverage a mobile that wants to register, or calls for help, waits for a cell, until its terminal
            // gives up
            return;
        }
        passed(PassingStep.Kind.CHANNEL_REQUEST, cell(), "", 0);
        long delayNanos = Math.max(0, idleNanos - timers.nowNanos());
        requests.begin(network.towers().get(tower), timingAdvance(tower), firstMessage, delayNanos);
    }

    private void establish() {
        // idle mode continues during the access, and may have selected another cell by now
        BaseStation tower = requests.tower();
        requests.end();
        Optional<TowerChannel> assigned =
                tower.channel(granted.channel().channel()).filter(TowerChannel::isAwaiting);
        if (assigned.isEmpty()) {
            LOG.log(Level.DEBUG, "{0}: {1} is not active", this, granted.channel());
            machine.fire(MobileRadioEvent.CHANNEL_LOST);
            return;
        }
        change.begin();
        take(assigned.get());
        passed(PassingStep.Kind.IMMEDIATE_ASSIGNMENT, cell(), "", granted.timingAdvance());
        channel.establish(receiver, PowerClass.in(tower.tower().arfcn(), firstMessage));
    }

    /** Moves to a channel. */
    void take(TowerChannel newChannel) {
        channel = newChannel;
        link.moved(newChannel.tower());
        if (newChannel.isTraffic()) {
            speech.restart();
        }
    }

    TowerChannel current() {
        return channel;
    }

    ChannelUser user() {
        return receiver;
    }

    MobileSpeech speech() {
        return speech;
    }

    void fire(MobileRadioEvent event) {
        machine.fire(event);
    }

    int timingAdvance(int tower) {
        return reception.timingAdvance(tower, walker.place());
    }

    private void forsake() {
        change.end();
        if (channel != null) {
            channel.forsake(true);
        }
    }

    private void forget() {
        change.end();
        if (channel != null) {
            idleNanos = timers.nowNanos() + RETURN_NANOS;
            selection.camp(serving(), timers.nowNanos());
        }
        channel = null;
        link.cipher(CipherKey.NONE);
        speech.callEnded();
        granted = null;
        firstMessage = null;
        held.clear();
    }

    private boolean isReachable() {
        return machine.state() == MobileRadioState.DEDICATED && channel.isActive() && link.isUsable();
    }

    private void pass(RslMessage.DataRequest message) {
        if (message.sapi() == Sapi.SIGNALLING && change.takes(message.layer3())) {
            return;
        }
        Optional<Integer> area = identity.readDownlink(message.layer3());
        send(message);
        area.ifPresent(code -> network.happened(new MobileEvent.LocationUpdated(this, code)));
    }

    /** Moves, measures, and selects a cell or reports. */
    public void measure() {
        measurements.measure();
    }

    /** Sends layer 3 that waited for a better signal, after a measurement. */
    void measured() {
        held.pass();
    }

    /** True if the terminal has sent its first message, so that it searches cells. */
    boolean isSwitchedOn() {
        return identity.number().isPresent() || firstMessage != null;
    }

    /** Begins an access that waited for a cell, after its selection. */
    void camped() {
        if (machine.state() == MobileRadioState.ACCESS && !requests.isUnderWay()) {
            requestChannel();
        }
    }

    void passed(PassingStep.Kind step, String from, String to, int figure) {
        network.happened(new MobileEvent.Passed(this, step, from, to, figure));
    }

    @Override
    public String toString() {
        return number();
    }
}
