package simgsm.center.bsc;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import simgsm.abis.RslElement;
import simgsm.abis.RslPdu;
import simgsm.abis.RslType;
import simgsm.air.ChannelDescription;
import simgsm.air.ChannelNumber;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.center.bsc.ChannelTable.ChannelAction;
import simgsm.center.bsc.ChannelTable.ChannelEvent;
import simgsm.center.bsc.ChannelTable.ChannelState;
import simgsm.center.bsc.handover.HandoverDecision;
import simgsm.center.bsc.handover.Measurement;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;
import simgsm.state.StateMachine;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/** One dedicated channel of a tower: {@link ChannelTable} driven by the tower's messages and the connection that uses it. */
final class DedicatedChannel {
    /** Short messages (TS 44.005). */
    private static final int SAPI_3 = 3;

    private static final int NO_DTX = 0;
    private static final int SPEECH = 1;
    private static final int SIGNALLING = 3;
    private static final int RATE_SDCCH = 1;
    private static final int RATE_TCH_F = 8;
    private static final int CODING_NONE = 0;
    /** GSM 06.10. */
    private static final int CODING_FULL_RATE = 1;
    /** Tag of a channel description inside the channel identification. */
    private static final int CHANNEL_DESCRIPTION_TAG = 0x64;
    /** Mobile allocation of length 0. */
    private static final int MOBILE_ALLOCATION_TAG = 0x72;
    /** Release mode: local end (TS 48.058, 9.3.20). */
    private static final int LOCAL_END = 1;

    /** Reason of a channel's activation (TS 48.058, 9.3.3). */
    enum Purpose {
        IMMEDIATE_ASSIGNMENT(0),
        ASSIGNMENT(1),
        /** the cells are not synchronised */
        HANDOVER(2);

        private final int code;

        Purpose(int code) {
            this.code = code;
        }
    }

    private final TowerControl tower;
    private final ChannelNumber number;
    private final StateMachine<ChannelState, ChannelEvent, ChannelAction> machine =
            new StateMachine<>(ChannelTable.ROWS, this, this::perform).onEntry(before -> entered());
    private final ChannelSpeech speech;
    private final Deque<OctetString> waitingForSapi3 = new ArrayDeque<>();
    private boolean isSapi3Open;
    private boolean isSapi3Opening;
    private RadioConnection user;
    private Purpose purpose;
    private boolean isForSpeech;
    private boolean isChangingMode;
    private int accessDelay;
    private int handoverReference;
    private HandoverDecision decision;
    private Timer guard;

    DedicatedChannel(TowerControl tower, ChannelNumber number) {
        this.tower = tower;
        this.number = number;
        this.speech = new ChannelSpeech(this);
    }

    TowerControl tower() {
        return tower;
    }

    ChannelNumber number() {
        return number;
    }

    boolean isFree() {
        return machine.state() == ChannelState.FREE;
    }

    ChannelSpeech speech() {
        return speech;
    }

    /** The decision on this channel's measurements; null on a signalling channel. */
    HandoverDecision decision() {
        return decision;
    }

    ChannelDescription description() {
        return new ChannelDescription(
                number, tower.plan().trainingSequence(), tower.plan().cell().frequency());
    }

    /** The command that moves a mobile in this cell to this channel. */
    RadioResource assignmentCommand() {
        return new RadioResource.AssignmentCommand(
                description(), tower.plan().powerLevel(), RadioResource.SPEECH_FULL_RATE);
    }

    /** The command that moves a mobile in another cell to this channel. */
    RadioResource handoverCommand() {
        return new RadioResource.HandoverCommand(
                tower.plan().cell(),
                description(),
                handoverReference,
                tower.plan().powerLevel(),
                Optional.of(RadioResource.SPEECH_FULL_RATE));
    }

    /** The command that starts speech on this channel. */
    RadioResource modeCommand() {
        return new RadioResource.ChannelModeModify(description(), RadioResource.SPEECH_FULL_RATE);
    }

    /**
     * Assigns the channel to a connection.
     *
     * @param reference of a handover, else unused
     */
    void activate(RadioConnection connection, Purpose why, int delay, int reference) {
        user = connection;
        purpose = why;
        isForSpeech = why != Purpose.IMMEDIATE_ASSIGNMENT;
        isChangingMode = false;
        accessDelay = delay;
        handoverReference = reference;
        decision = canCarrySpeech() ? tower.settings().handover().decision() : null;
        machine.fire(ChannelEvent.ACTIVATE);
    }

    /** Ends the radio connection; CHANNEL RELEASE has been sent. */
    void release() {
        machine.fire(ChannelEvent.RELEASE);
    }

    /** Ends the channel of a mobile that is absent or lost. */
    void abandon() {
        machine.fire(ChannelEvent.ABANDON);
    }

    /** True for a traffic channel, in any mode. */
    boolean canCarrySpeech() {
        return number.kind().isSpeech();
    }

    /** True if the channel is in its mode for speech. */
    boolean carriesSpeech() {
        return canCarrySpeech() && isForSpeech;
    }

    /** Requests the mode for speech, which the mobile already has, from the tower. */
    void modifyMode() {
        isChangingMode = true;
        tower.send(RslPdu.of(RslType.MODE_MODIFY_REQUEST, number).with(RslElement.CHANNEL_MODE, mode(true)));
    }

    private void modeModified(boolean isDone) {
        if (isChangingMode && machine.state() == ChannelState.ACTIVE) {
            isChangingMode = false;
            // a call that has waited too long has ended without a speech path
            isForSpeech = user.modeModified(this, isDone) && isDone;
        }
    }

    /** Sends a layer 3 message; one of SAPI 3 opens that link first. */
    void send(int sapi, OctetString layer3) {
        if (sapi != SAPI_3 || isSapi3Open) {
            tower.send(RslPdu.of(RslType.DATA_REQUEST, number, sapi).with(RslElement.L3_INFORMATION, layer3));
        } else {
            waitingForSapi3.add(layer3);
            if (!isSapi3Opening) {
                isSapi3Opening = true;
                tower.send(RslPdu.of(RslType.ESTABLISH_REQUEST, number, SAPI_3));
            }
        }
    }

    /** Lets the tower cipher, and sends the command to the mobile. */
    void cipher(OctetString information, OctetString command) {
        tower.send(RslPdu.of(RslType.ENCRYPTION_COMMAND, number)
                .with(RslElement.ENCRYPTION_INFORMATION, information)
                .with(RslElement.LINK_IDENTIFIER, 0)
                .with(RslElement.L3_INFORMATION, command));
    }

    void send(RslPdu message) {
        tower.send(message);
    }

    /** Handles a message of the tower for this channel. */
    void receive(RslPdu message) throws ProtocolViolation {
        switch (message.type()) {
            case CHANNEL_ACTIVATION_ACKNOWLEDGE -> machine.fire(ChannelEvent.ACTIVATED);
            case CHANNEL_ACTIVATION_NEGATIVE_ACKNOWLEDGE -> machine.fire(ChannelEvent.REFUSED);
            case RF_CHANNEL_RELEASE_ACKNOWLEDGE -> machine.fire(ChannelEvent.FREED);
            case MODE_MODIFY_ACKNOWLEDGE -> modeModified(true);
            case MODE_MODIFY_NEGATIVE_ACKNOWLEDGE -> modeModified(false);
            case CREATE_CONNECTION_ACKNOWLEDGE -> speech.created(message);
            case CREATE_CONNECTION_NEGATIVE_ACKNOWLEDGE, MODIFY_CONNECTION_NEGATIVE_ACKNOWLEDGE -> speech.refused();
            case ESTABLISH_CONFIRM -> established(message.sapi());
            case RELEASE_CONFIRM -> released(message.sapi());
            case ESTABLISH_INDICATION -> {
                established(message.sapi());
                tell(message);
            }
            case RELEASE_INDICATION -> {
                released(message.sapi());
                tell(message);
            }
            case DATA_INDICATION, ERROR_INDICATION, CONNECTION_FAILURE, HANDOVER_DETECTION -> tell(message);
            case MEASUREMENT_RESULT -> measured(message);
            default -> {
                // the other answers need no action
            }
        }
    }

    private void tell(RslPdu message) throws ProtocolViolation {
        boolean isEnding = machine.state() == ChannelState.CLOSING || machine.state() == ChannelState.LEAVING;
        if (machine.state() == ChannelState.ACTIVE || isEnding && message.type() == RslType.RELEASE_INDICATION) {
            user.receive(this, message);
        }
    }

    private void measured(RslPdu message) throws ProtocolViolation {
        if (machine.state() == ChannelState.ACTIVE) {
            Measurement measurement = tower.measurement(message);
            if (decision != null) {
                decision.add(measurement);
            }
            user.measured(this, measurement);
        }
    }

    private void established(int sapi) {
        if (sapi == SAPI_3) {
            isSapi3Open = true;
            isSapi3Opening = false;
            while (!waitingForSapi3.isEmpty()) {
                send(SAPI_3, waitingForSapi3.remove());
            }
        }
    }

    private void released(int sapi) {
        if (sapi == SAPI_3) {
            isSapi3Open = false;
            isSapi3Opening = false;
            machine.fire(ChannelEvent.LINKS_CLOSED);
        }
    }

    private void entered() {
        timers().cancel(guard);
        switch (machine.state()) {
            case ACTIVATING -> guard(BscTimer.ACTIVATION, ChannelEvent.UNANSWERED);
            case CLOSING -> guard(BscTimer.T3109, ChannelEvent.T3109_EXPIRED);
            case LEAVING -> guard(BscTimer.T3111, ChannelEvent.T3111_EXPIRED);
            case FREEING -> {
                speech.close();
                guard(BscTimer.RF_RELEASE, ChannelEvent.UNANSWERED);
                user.channelEnded(this);
            }
            default -> {
                // no timer runs in the other states; the connection supervises the mobile
            }
        }
    }

    private Timers timers() {
        return tower.timers();
    }

    private void guard(BscTimer timer, ChannelEvent expiry) {
        guard = timers().start(timer.nanos(), () -> machine.fire(expiry));
    }

    private void perform(ChannelAction action) {
        switch (action) {
            case SEND_ACTIVATION -> tower.send(activation());
            case SEND_DEACTIVATE_SACCH -> tower.send(RslPdu.of(RslType.DEACTIVATE_SACCH, number));
            case SEND_RELEASE_REQUEST -> closeLinks();
            case START_T3111 -> speech.close();
            case SEND_RF_RELEASE -> tower.send(RslPdu.of(RslType.RF_CHANNEL_RELEASE, number));
            case TELL_ACTIVE -> user.channelActivated(true);
            case TELL_FAILED -> user.channelActivated(false);
            case TELL_FREE -> {
                isSapi3Open = false;
                isSapi3Opening = false;
                waitingForSapi3.clear();
                tower.freed();
            }
        }
    }

    private void closeLinks() {
        if (isSapi3Open) {
            tower.send(RslPdu.of(RslType.RELEASE_REQUEST, number, SAPI_3).with(RslElement.RELEASE_MODE, LOCAL_END));
        } else {
            machine.fire(ChannelEvent.LINKS_CLOSED);
        }
    }

    private RslPdu activation() {
        OctetString identification = new OctetWriter()
                .octet(CHANNEL_DESCRIPTION_TAG)
                .string(description().encode())
                .octet(MOBILE_ALLOCATION_TAG)
                .octet(0)
                .toOctetString();
        RslPdu message = RslPdu.of(RslType.CHANNEL_ACTIVATION, number)
                .with(RslElement.ACTIVATION_TYPE, purpose.code)
                .with(RslElement.CHANNEL_MODE, mode(isForSpeech))
                .with(RslElement.CHANNEL_IDENTIFICATION, identification);
        if (user.cipher().information().isPresent()) {
            message = message.with(
                    RslElement.ENCRYPTION_INFORMATION,
                    user.cipher().information().get());
        }
        if (purpose == Purpose.HANDOVER) {
            message = message.with(RslElement.HANDOVER_REFERENCE, handoverReference);
        }
        message = message.with(RslElement.BS_POWER, 0)
                .with(RslElement.MS_POWER, tower.plan().powerLevel());
        if (purpose != Purpose.HANDOVER) {
            message = message.with(RslElement.TIMING_ADVANCE, accessDelay);
        }
        return message.with(RslElement.MS_POWER_PARAMETERS);
    }

    private int[] mode(boolean isSpeech) {
        return new int[] {
            NO_DTX,
            isSpeech ? SPEECH : SIGNALLING,
            canCarrySpeech() ? RATE_TCH_F : RATE_SDCCH,
            isSpeech ? CODING_FULL_RATE : CODING_NONE
        };
    }

    /** Passes on speech of this channel's mobile. */
    void heard(byte[] rtp) {
        if (machine.state() == ChannelState.ACTIVE) {
            user.heard(rtp);
        }
    }

    /** Handles the lack of a path for this channel's speech between tower and exchange. */
    void speechRefused() {
        if (machine.state() == ChannelState.ACTIVE) {
            user.speechRefused(this);
        }
    }

    /** Ends the channel with its tower. */
    void lost() {
        timers().cancel(guard);
        speech.close();
        if (!isFree() && user != null) {
            user.channelLost(this);
        }
    }

    @Override
    public String toString() {
        return tower + " " + number;
    }
}
