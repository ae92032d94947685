package simgsm.center.msc.call;

import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simgsm.abis.IpaFrame;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.CauseLocation;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallAction;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallEvent;
import simgsm.center.msc.call.NetworkCallTable.NetworkCallState;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.center.msc.link.PagedTransaction;
import simgsm.center.msc.link.RadioAccess.SpeechNeed;
import simgsm.ss.NotifySs;
import simgsm.ss.SsCode;
import simgsm.state.StateMachine;
import simgsm.timer.Timer;
import simgsm.tone.ToneSet;

/** One mobile's leg of a call: {@link NetworkCallTable} driven by the mobile's messages, the call, and timers. */
public final class CallLeg implements PagedTransaction {
    private static final Map<Class<? extends CallControl>, NetworkCallEvent> EVENTS = Map.of(
            CallControl.Setup.class, NetworkCallEvent.SETUP_RECEIVED,
            CallControl.EmergencySetup.class, NetworkCallEvent.SETUP_RECEIVED,
            CallControl.CallConfirmed.class, NetworkCallEvent.CALL_CONFIRMED_RECEIVED,
            CallControl.Alerting.class, NetworkCallEvent.ALERTING_RECEIVED,
            CallControl.Connect.class, NetworkCallEvent.CONNECT_RECEIVED,
            CallControl.ConnectAcknowledge.class, NetworkCallEvent.CONNECT_ACKNOWLEDGE_RECEIVED);

    private static final Set<NetworkCallEvent> CLEARED_BY_USER = EnumSet.of(
            NetworkCallEvent.DISCONNECT_RECEIVED,
            NetworkCallEvent.RELEASE_RECEIVED,
            NetworkCallEvent.RELEASE_COMPLETE_RECEIVED);

    private final NetworkCall call;
    private final LinkCalls legs;
    private final Link link;
    private final TransactionIdentifier transaction;
    private final Optional<Msisdn> calling;
    private final StateMachine<NetworkCallState, NetworkCallEvent, NetworkCallAction> machine =
            new StateMachine<>(NetworkCallTable.ROWS, this, this::perform).onEntry(this::entered);
    private final NetworkTones networkTones;
    private Timer guard;
    private boolean isReleaseRepeated;
    private boolean isHeld;
    private boolean isSpeechRefused;
    private boolean isClearedByUser;
    /** The cause of the leg's clearing, for the other leg. */
    private Cause cause = Cause.NORMAL_CALL_CLEARING;
    /** The cause in the clearing message to the mobile; empty if the mobile clears. */
    private Optional<Cause> sentCause = Optional.empty();

    private CauseLocation location = CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER;
    /** True if the message of this state announces a tone of the network. */
    private boolean announcesTone;
    /** Null until the mobile signals its first key. */
    private ToneSender keyTones;

    /**
     * @param transaction as written by the network
     * @param calling the caller's number, for a called mobile; empty on the caller's leg
     * @param toneSet of the network's tones for a caller, if any
     */
    CallLeg(
            NetworkCall call,
            LinkCalls legs,
            TransactionIdentifier transaction,
            Optional<Msisdn> calling,
            Optional<ToneSet> toneSet) {
        this.call = call;
        this.legs = legs;
        this.link = legs.link();
        this.transaction = transaction;
        this.calling = calling;
        this.networkTones = new NetworkTones(toneSet, link);
    }

    Link link() {
        return link;
    }

    public TransactionIdentifier transaction() {
        return transaction;
    }

    public NetworkCallState state() {
        return machine.state();
    }

    CallLeg listener() {
        return call.listenerOf(this);
    }

    // From the call.

    void page() {
        machine.fire(NetworkCallEvent.PAGE);
        link.paging().request(this);
    }

    void proceed() {
        machine.fire(NetworkCallEvent.PROCEED);
    }

    void alert() {
        machine.fire(NetworkCallEvent.ALERT);
    }

    void answer() {
        machine.fire(NetworkCallEvent.ANSWER);
    }

    /**
     * Clears this leg for a cause on the other leg.
     *
     * @param byUser true if the other mobile sent it
     */
    void clear(Cause why, boolean byUser) {
        location = byUser ? CauseLocation.USER : CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER;
        fire(NetworkCallEvent.CLEAR, why, Optional.of(why));
    }

    /** Clears both legs, because this leg's mobile gets no traffic channel. */
    void refuseSpeech(Cause why) {
        isSpeechRefused = true;
        clear(why, false);
        call.cleared(this, why);
    }

    // From the link.

    @Override
    public void radioConnected() {
        machine.fire(NetworkCallEvent.RADIO_CONNECTED);
    }

    @Override
    public void pagingFailed() {
        fire(NetworkCallEvent.PAGING_FAILED, Cause.DESTINATION_OUT_OF_ORDER, Optional.empty());
    }

    void linkLost() {
        boolean isUnreachable = this != call.originating() && !state().speaks();
        Cause why = isUnreachable ? Cause.DESTINATION_OUT_OF_ORDER : Cause.TEMPORARY_FAILURE;
        fire(NetworkCallEvent.LINK_LOST, why, Optional.empty());
    }

    /** Handles a message of this transaction; one without a row in this state is answered with STATUS. */
    void receive(CallControl message) {
        if (message instanceof CallControl.StatusEnquiry) {
            sendStatus(Cause.RESPONSE_TO_STATUS_ENQUIRY);
        } else if (message instanceof CallControl.StartDtmf start) {
            keyTones().start(start.key());
        } else if (message instanceof CallControl.StopDtmf) {
            keyTones().stop();
        } else if (message instanceof CallControl.Hold) {
            hold();
        } else if (message instanceof CallControl.Retrieve) {
            retrieve();
        } else if (message instanceof CallControl.Status status) {
            if (status.callState() == NetworkCallState.NULL.code()) {
                fire(NetworkCallEvent.STATUS_NULL_RECEIVED, status.cause(), Optional.empty());
            }
        } else if (!receiveForTable(message)) {
            sendStatus(Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
    }

    /** True if speech passes between the mobile and this leg. */
    boolean speaks() {
        return state().speaks() && !isHeld;
    }

    /** The leg's need of the mobile's speech path; none after a refusal. */
    SpeechNeed speechNeed() {
        if (isSpeechRefused) {
            return SpeechNeed.NONE;
        }
        if (state().mayHear()) {
            return SpeechNeed.HEARD;
        }
        return state().needsSpeechPath() ? SpeechNeed.PREPARED : SpeechNeed.NONE;
    }

    /** True if the mobile holds the call (TS 24.083, 2). */
    boolean isHeld() {
        return isHeld;
    }

    private void hold() {
        if (state() == NetworkCallState.ACTIVE && !isHeld) {
            isHeld = true;
            endKeys();
            link.send(new CallControl.HoldAcknowledge(transaction));
            call.holdChanged(this);
        } else {
            link.send(new CallControl.HoldReject(transaction, Cause.MESSAGE_NOT_COMPATIBLE_WITH_CALL_STATE));
        }
    }

    /** Retrieves the call, only while no other call is active. */
    private void retrieve() {
        boolean isFree = legs.live().stream().noneMatch(leg -> leg != this && !leg.isHeld);
        if (isHeld && isFree) {
            isHeld = false;
            link.send(new CallControl.RetrieveAcknowledge(transaction));
            call.holdChanged(this);
        } else {
            link.send(new CallControl.RetrieveReject(transaction, Cause.MESSAGE_NOT_COMPATIBLE_WITH_CALL_STATE));
        }
    }

    /** Notifies this mobile of hold and retrieval by the other one. */
    void notifyHold(boolean onHold) {
        if (state().speaks()) {
            link.send(new CallControl.Facility(
                    transaction, (onHold ? NotifySs.CALL_ON_HOLD : NotifySs.CALL_RETRIEVED).facility()));
        }
    }

    /** Notifies the mobile of a forwarding; a caller, once the network has accepted its call (TS 24.082). */
    void notify(NotifySs what, SsCode condition) {
        if (what == NotifySs.INCOMING_CALL_FORWARDED
                || state() == NetworkCallState.CALL_PROCEEDING
                || state() == NetworkCallState.CALL_DELIVERED) {
            link.send(new CallControl.Facility(transaction, what.facility(condition)));
        }
    }

    /** Plays a tone to this mobile while the other party holds the call. */
    void heldByOther(boolean nowHeld) {
        if (nowHeld && state().speaks()) {
            networkTones.playHold();
        } else {
            networkTones.stop();
        }
    }

    void playNotice() {
        networkTones.playNotice();
    }

    private void endKeys() {
        if (keyTones != null) {
            keyTones.end();
        }
    }

    private boolean receiveForTable(CallControl message) {
        if (message instanceof CallControl.Disconnect disconnect) {
            return fire(NetworkCallEvent.DISCONNECT_RECEIVED, disconnect.cause(), Optional.empty());
        }
        if (message instanceof CallControl.Release release) {
            return fire(NetworkCallEvent.RELEASE_RECEIVED, orNormal(release.cause()), Optional.empty());
        }
        if (message instanceof CallControl.ReleaseComplete complete) {
            return fire(NetworkCallEvent.RELEASE_COMPLETE_RECEIVED, orNormal(complete.cause()), Optional.empty());
        }
        NetworkCallEvent event = EVENTS.get(message.getClass());
        return event != null && machine.fire(event);
    }

    /** True if the mobile has cleared the leg. */
    boolean isClearedByUser() {
        return isClearedByUser;
    }

    private static Cause orNormal(Optional<Cause> cause) {
        return cause.orElse(Cause.NORMAL_CALL_CLEARING);
    }

    private ToneSender keyTones() {
        if (keyTones == null) {
            keyTones = new ToneSender(this);
        }
        return keyTones;
    }

    /** The frame for the other leg: this one, the tone of a signalled key, or null for none. */
    IpaFrame audible(IpaFrame speech) {
        return keyTones == null ? speech : keyTones.inPlaceOf(speech);
    }

    private void sendStatus(Cause why) {
        link.send(new CallControl.Status(transaction, why, state().code()));
    }

    /**
     * @param why the cause for the other leg if this one is cleared
     * @param sent the cause for the mobile if the network clears it
     */
    private boolean fire(NetworkCallEvent event, Cause why, Optional<Cause> sent) {
        if (machine.accepts(event) && !state().isClearing()) {
            cause = why;
            sentCause = sent;
            isClearedByUser = CLEARED_BY_USER.contains(event);
        }
        return machine.fire(event);
    }

    private void entered(NetworkCallState before) {
        announcesTone = announcesTone(before);
        networkTones.stop();
        restartGuard();
        if (!state().speaks()) {
            endKeys();
        }
        legs.changed(this);
    }

    /** True if a tone is played to a caller before the call is connected. */
    private boolean announcesTone(NetworkCallState before) {
        return switch (state()) {
            case CALL_DELIVERED -> networkTones.hasRingBack();
            case DISCONNECT_INDICATION ->
                (before == NetworkCallState.CALL_PROCEEDING || before == NetworkCallState.CALL_DELIVERED)
                        && networkTones.has(cause);
            default -> false;
        };
    }

    private void restartGuard() {
        link.timers().cancel(guard);
        guard = state().guard(announcesTone)
                .map(timer -> link.timers()
                        .start(timer == NetworkTimer.T303 ? call.setupNanos() : timer.nanos(), () -> expired(timer)))
                .orElse(null);
    }

    private void expired(NetworkTimer timer) {
        boolean isAgain = timer == NetworkTimer.T308 && isReleaseRepeated;
        isReleaseRepeated |= timer == NetworkTimer.T308;
        fire(
                isAgain ? NetworkCallEvent.T308_EXPIRED_AGAIN : NetworkCallEvent.expiryOf(timer),
                causeOf(timer),
                Optional.of(Cause.RECOVERY_ON_TIMER_EXPIRY));
    }

    private static Cause causeOf(NetworkTimer timer) {
        return switch (timer) {
            case T301 -> Cause.USER_ALERTING_NO_ANSWER;
            case T303, T310 -> Cause.NO_USER_RESPONDING;
            default -> Cause.RECOVERY_ON_TIMER_EXPIRY;
        };
    }

    private void perform(NetworkCallAction action) {
        switch (action) {
            case SEND_SETUP ->
                link.send(new CallControl.Setup(
                        transaction, waitingSignal(), calling, Optional.empty(), call.redirecting(), false));
            case SEND_CALL_PROCEEDING -> link.send(new CallControl.CallProceeding(transaction));
            case SEND_ALERTING -> link.send(new CallControl.Alerting(transaction, announcesTone));
            case SEND_CONNECT -> link.send(new CallControl.Connect(transaction, call.connected()));
            case SEND_CONNECT_ACKNOWLEDGE -> link.send(new CallControl.ConnectAcknowledge(transaction));
            case SEND_DISCONNECT ->
                link.send(new CallControl.Disconnect(transaction, sentCause.orElse(cause), location, announcesTone));
            case SEND_RELEASE ->
                link.send(new CallControl.Release(transaction, sentCause, sentCause.map(sent -> location)));
            case SEND_RELEASE_COMPLETE ->
                link.send(new CallControl.ReleaseComplete(transaction, sentCause, sentCause.map(sent -> location)));
            case START_T308 -> restartGuard();
            case PLAY_TONE -> {
                if (announcesTone) {
                    networkTones.play(state(), cause);
                }
            }
            case TELL_OFFERED -> call.offered();
            case TELL_ALERTING -> call.alerting();
            case TELL_ANSWERED -> call.answered();
            case TELL_ACTIVE -> call.active();
            case TELL_CLEARED -> call.cleared(this, cause);
        }
    }

    /** Marks a second call as waiting (TS 24.083, 1). */
    private Optional<CallControl.Signal> waitingSignal() {
        boolean isSecond = legs.live().stream().anyMatch(leg -> leg != this);
        return isSecond ? Optional.of(CallControl.Signal.CALL_WAITING) : Optional.empty();
    }

    @Override
    public String toString() {
        return link + " " + state();
    }
}
