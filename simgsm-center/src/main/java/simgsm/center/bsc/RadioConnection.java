package simgsm.center.bsc;

import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.OptionalLong;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslElement;
import simgsm.abis.RslMessage;
import simgsm.abis.RslPdu;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Type;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.center.bsc.ConnectionTable.ConnectionAction;
import simgsm.center.bsc.ConnectionTable.ConnectionEvent;
import simgsm.center.bsc.ConnectionTable.ConnectionState;
import simgsm.center.bsc.DedicatedChannel.Purpose;
import simgsm.center.bsc.handover.Measurement;
import simgsm.octets.OctetString;
import simgsm.state.StateMachine;
import simgsm.timer.Timer;

/** One mobile's radio connection: {@link ConnectionTable} driven by its channels, its messages and the exchange. */
final class RadioConnection {
    private static final System.Logger LOG = System.getLogger(RadioConnection.class.getName());
    private static final int SAPI_0 = 0;

    private final BaseStationController controller;
    private final ChannelRequest request;
    private final StateMachine<ConnectionState, ConnectionEvent, ConnectionAction> machine =
            new StateMachine<>(ConnectionTable.ROWS, this, this::perform).onEntry(this::entered);
    private final HeldDownlink held = new HeldDownlink();
    private final ConnectionCipher cipher = new ConnectionCipher(this);
    private DedicatedChannel channel;
    /** The channel of a running assignment or handover; null otherwise. */
    private DedicatedChannel target;
    /** Null until the first message has identified the mobile. */
    private TowerMobile mobile;

    private OctetString firstMessage;
    private boolean isSpeechNeeded;
    /** Start of the call's wait for a traffic channel, including failed directed retries. */
    private OptionalLong waitingSinceNanos = OptionalLong.empty();
    /** True once the mobile has reached the target cell; its speech is then sent only there. */
    private boolean isDetected;

    private Timer guard;

    private RadioConnection(BaseStationController controller, ChannelRequest request, DedicatedChannel first) {
        this.controller = controller;
        this.request = request;
        this.channel = first;
    }

    /** Begins with a mobile's request and the channel activated for it. */
    static void begin(BaseStationController controller, ChannelRequest request, DedicatedChannel first) {
        RadioConnection connection = new RadioConnection(controller, request, first);
        first.activate(connection, Purpose.IMMEDIATE_ASSIGNMENT, request.accessDelay(), 0);
    }

    DedicatedChannel channel() {
        return channel;
    }

    /** Assigns the connection to the mobile that has proved its identity. */
    void belongTo(TowerMobile proved) {
        mobile = proved;
    }

    boolean isSuspended() {
        return machine.state() == ConnectionState.ASSIGNING || machine.state() == ConnectionState.HANDING_OVER;
    }

    void send(int sapi, OctetString layer3) {
        if (isSuspended()) {
            held.add(sapi, layer3);
        } else if (machine.state() != ConnectionState.ENDED) {
            channel.send(sapi, layer3);
        }
    }

    TowerMobile mobile() {
        return mobile;
    }

    ConnectionCipher cipher() {
        return cipher;
    }

    void release() {
        if (isSuspended()) {
            held.addRelease();
        } else {
            machine.fire(ConnectionEvent.RELEASE);
        }
    }

    /** @param isNeeded true while a call needs a traffic channel */
    void setSpeechNeeded(boolean isNeeded) {
        if (isNeeded == isSpeechNeeded) {
            return;
        }
        isSpeechNeeded = isNeeded;
        waitingSinceNanos = OptionalLong.empty();
        if (isNeeded) {
            seekSpeech();
        } else {
            machine.fire(ConnectionEvent.SPEECH_UNUSED);
        }
    }

    /** Searches for a traffic channel, and waits for one if none is free. */
    void seekSpeech() {
        if (!isSpeechNeeded || channel.carriesSpeech()) {
            return;
        }
        if (channel.canCarrySpeech()) {
            machine.fire(ConnectionEvent.MODIFY);
            return;
        }
        Optional<DedicatedChannel> free = channel.tower().freeTrafficChannel();
        if (free.isPresent() && machine.accepts(ConnectionEvent.ASSIGN)) {
            target = free.get();
            machine.fire(ConnectionEvent.ASSIGN);
        } else if (machine.fire(ConnectionEvent.QUEUE)) {
            channel.tower().queue(this);
        }
    }

    /** Start of this connection's wait for a traffic channel; the oldest is served first. */
    long waitingSinceNanos() {
        return waitingSinceNanos.orElseThrow();
    }

    /** Sends speech to both cells until the mobile has reached the target. */
    void sendSpeech(byte[] rtp) {
        boolean isMoving = target != null && machine.state() == ConnectionState.HANDING_OVER;
        if (!isMoving || !isDetected) {
            channel.speech().send(rtp);
        }
        if (isMoving) {
            target.speech().send(rtp);
        }
    }

    void heard(byte[] rtp) {
        if (mobile != null) {
            controller.uplink().spoke(mobile.link(), new IpaFrame(IpaFrame.SPEECH, rtp));
        }
    }

    /** Ends the connection because another one of the same mobile has begun, or its link has ended. */
    void lost() {
        machine.fire(ConnectionEvent.LOST);
    }

    void channelActivated(boolean isDone) {
        machine.fire(isDone ? ConnectionEvent.CHANNEL_ACTIVE : ConnectionEvent.CHANNEL_FAILED);
    }

    /** Handles the end of a channel, which the mobile has left by now. */
    void channelEnded(DedicatedChannel ended) {
        if (ended == channel && machine.state() == ConnectionState.ENDED) {
            disconnected();
        }
    }

    /** Handles the tower's answer to MODE MODIFY REQUEST. @return false if it is too late */
    boolean modeModified(DedicatedChannel of, boolean isDone) {
        return of == channel && machine.fire(isDone ? ConnectionEvent.CHANNEL_ACTIVE : ConnectionEvent.MODE_REFUSED);
    }

    /** Handles a channel without speech: a call that needs it ends, once the mobile has arrived. */
    void speechRefused(DedicatedChannel on) {
        if (on == channel && !isSuspended()) {
            refuseSpeech();
        }
    }

    /** Handles the loss of a channel's tower. */
    void channelLost(DedicatedChannel gone) {
        if (gone == target) {
            targetLost();
        } else if (gone == channel && machine.state() != ConnectionState.HANDING_OVER) {
            machine.fire(ConnectionEvent.LOST);
            disconnected();
        }
    }

    /** A mobile that does not reach the other cell returns to this one with HANDOVER FAILURE; T3103 waits for it. */
    private void targetLost() {
        switch (machine.state()) {
            case PREPARING_HANDOVER -> machine.fire(ConnectionEvent.CHANNEL_FAILED);
            case HANDING_OVER -> target = null;
            default -> machine.fire(ConnectionEvent.LOST);
        }
    }

    void receive(DedicatedChannel from, RslPdu message) throws ProtocolViolation {
        switch (message.type()) {
            case ESTABLISH_INDICATION, DATA_INDICATION -> {
                if (message.has(RslElement.L3_INFORMATION)) {
                    receiveLayer3(from, message.sapi(), message.value(RslElement.L3_INFORMATION));
                }
            }
            case RELEASE_INDICATION -> {
                if (message.sapi() == SAPI_0) {
                    left(from);
                }
            }
            case CONNECTION_FAILURE -> {
                if (from == channel && !isSuspended()) {
                    machine.fire(ConnectionEvent.LOST);
                }
            }
            case HANDOVER_DETECTION -> isDetected |= from == target;
            // ERROR INDICATION: a mobile's link layer has failed, which is no protocol error of the tower.
            default -> LOG.log(Level.DEBUG, "{0}: {1}", this, message.type().title());
        }
    }

    private void left(DedicatedChannel from) {
        if (machine.state() == ConnectionState.ENDED) {
            disconnected();
        } else if (from == channel && !isSuspended()) {
            machine.fire(ConnectionEvent.LOST);
        }
    }

    private void receiveLayer3(DedicatedChannel from, int sapi, OctetString layer3) {
        if (machine.state() == ConnectionState.GRANTED) {
            firstMessage = layer3;
            machine.fire(ConnectionEvent.MOBILE_ARRIVED);
        } else if (mobile != null && !cipher.receive(layer3) && !receiveRadioResource(from, layer3)) {
            if (sapi == RslMessage.Sapi.SHORT_MESSAGES.code()) {
                controller.uplink().established(mobile.link(), RslMessage.Sapi.SHORT_MESSAGES, layer3);
            } else {
                controller.uplink().received(mobile.link(), layer3);
            }
        }
    }

    /** Handles the end of an assignment or handover. @return false for any other message */
    private boolean receiveRadioResource(DedicatedChannel from, OctetString layer3) {
        Optional<ChannelOutcome> outcome = ChannelOutcome.of(layer3);
        outcome.ifPresent(found -> {
            mobile.link().trace(Direction.UPLINK, found.title(), layer3);
            if (from == (found.event() == ConnectionEvent.COMPLETED ? target : channel)) {
                machine.fire(found.event());
            }
        });
        return outcome.isPresent();
    }

    // Handover.

    void measured(DedicatedChannel from, Measurement measurement) {
        if (from != channel || !machine.accepts(ConnectionEvent.HANDOVER)) {
            return;
        }
        HandoverTarget targets = new HandoverTarget(controller);
        boolean isQueued = machine.state() == ConnectionState.QUEUED;
        (isQueued ? targets.elsewhere(channel, measurement) : targets.better(channel, channel.decision()))
                .ifPresent(free -> {
                    target = free;
                    machine.fire(ConnectionEvent.HANDOVER);
                });
    }

    // The table.

    private void entered(ConnectionState before) {
        controller.timers().cancel(guard);
        if (before == ConnectionState.QUEUED) {
            channel.tower().unqueue(this);
        }
        if (machine.state() == ConnectionState.QUEUED) {
            waitInQueue();
        } else {
            machine.state().guard().ifPresent(limit -> guard(limit.timer().nanos(), limit.expiry()));
        }
    }

    private void guard(long nanos, ConnectionEvent expiry) {
        guard = controller.timers().start(nanos, () -> machine.fire(expiry));
    }

    /** T11 runs from the first attempt: a failed directed retry does not restart it. */
    private void waitInQueue() {
        long now = controller.timers().nowNanos();
        if (waitingSinceNanos.isEmpty()) {
            waitingSinceNanos = OptionalLong.of(now);
        }
        guard(Math.max(0, waitingSinceNanos.getAsLong() + BscTimer.T11.nanos() - now), ConnectionEvent.T11_EXPIRED);
    }

    private void perform(ConnectionAction action) {
        switch (action) {
            case GRANT_ACCESS -> channel.tower().grant(request, channel);
            case REJECT_ACCESS -> channel.tower().reject(request);
            case TELL_ARRIVED -> arrived();
            case ACTIVATE_TARGET -> activateTarget();
            case COMMAND_ASSIGNMENT -> {
                command(target.assignmentCommand());
                target.speech().create();
            }
            case COMMAND_HANDOVER -> {
                target.speech().create();
                command(target.handoverCommand());
            }
            case COMMAND_MODE -> command(channel.modeCommand());
            case MODIFY_CHANNEL -> channel.modifyMode();
            case CREATE_SPEECH -> channel.speech().create();
            case SWITCH -> switchChannels();
            case SEND_WAITING -> {
                if (held.sendOn(channel)) {
                    machine.fire(ConnectionEvent.RELEASE);
                }
                if (channel.speech().isRefused()) {
                    refuseSpeech();
                }
            }
            case ABANDON_CHANNEL -> channel.abandon();
            case ABANDON_TARGET -> abandonTarget();
            case REFUSE_SPEECH -> refuseSpeech();
            case SEEK_SPEECH -> {
                target = null;
                seekSpeech();
            }
            case RELEASE_CHANNEL -> {
                command(new RadioResource.ChannelRelease(RadioResource.NORMAL_EVENT));
                channel.release();
            }
            case TELL_LOST -> disconnected();
        }
    }

    private void arrived() {
        cipher.readClassmark(firstMessage);
        mobile = controller.mobileOf(firstMessage, channel.tower());
        mobile.connected(this);
        controller.uplink().established(mobile.link(), RslMessage.Sapi.SIGNALLING, firstMessage);
    }

    private void activateTarget() {
        isDetected = false;
        boolean isHandover = machine.state() == ConnectionState.PREPARING_HANDOVER;
        target.activate(
                this,
                isHandover ? Purpose.HANDOVER : Purpose.ASSIGNMENT,
                request.accessDelay(),
                isHandover ? controller.nextHandoverReference() : 0);
    }

    private void command(RadioResource message) {
        channel.send(SAPI_0, traced(message));
    }

    /** The octets of a message to the mobile, which is traced. */
    OctetString traced(RadioResource message) {
        OctetString layer3 = OctetString.of(Layer3Codec.encode(message, Direction.DOWNLINK, 0));
        mobile.link().trace(Direction.DOWNLINK, Layer3Type.of(message).title(), layer3);
        return layer3;
    }

    private void switchChannels() {
        DedicatedChannel old = channel;
        channel = target;
        target = null;
        waitingSinceNanos = OptionalLong.empty();
        old.release();
    }

    private void abandonTarget() {
        if (target != null) {
            DedicatedChannel abandoned = target;
            target = null;
            abandoned.abandon();
        }
    }

    private void refuseSpeech() {
        if (isSpeechNeeded) {
            controller.uplink().speechRefused(mobile.link(), Cause.NO_CIRCUIT_AVAILABLE);
        }
    }

    private void disconnected() {
        if (mobile != null) {
            mobile.disconnected(this);
        }
    }

    @Override
    public String toString() {
        return (mobile == null ? "access" : mobile.link()) + " on " + channel;
    }
}
