package simgsm.station.call;

import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.TransactionIdentifier;
import simgsm.state.StateMachine;
import simgsm.station.call.MobileCallTable.MobileCallAction;
import simgsm.station.call.MobileCallTable.MobileCallEvent;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationTimer;
import simgsm.station.mobility.ServiceRequests;

/** The current call of a station, run by {@link MobileCallTable}, with its waiting or held second call. */
public final class MobileCall implements ServiceRequests.ServiceUser {
    private final StationContext context;
    private final CallSpeech speech;
    private final KeySignalling keys;
    private final boolean callWaiting;
    private final boolean ignoresSetup;
    private final SecondCall second;
    private final CallHold hold;
    private final StateMachine<MobileCallState, MobileCallEvent, MobileCallAction> machine;
    /** As in the messages sent; null in state NULL. */
    private TransactionIdentifier transaction;

    private Optional<Msisdn> peer = Optional.empty();
    /** For the clearing message. */
    private Cause sentCause = Cause.NORMAL_CALL_CLEARING;

    private Cause reportedCause = Cause.NORMAL_CALL_CLEARING;
    private final PeerHolds peerHolds;
    private final CallConnection connection;
    /** True while a message is processed that announces tones of the network. */
    private boolean tonesAnnounced;

    /** Dialled while the previous call was being cleared. */
    private Optional<Msisdn> next = Optional.empty();

    /**
     * @param callWaiting true if a second call may wait; else its caller is told that the user is busy
     * @param ignoresSetup a fault: offered calls are left unanswered
     */
    public MobileCall(
            StationContext context,
            ServiceRequests services,
            SpeechPath speech,
            KeySignalling keys,
            boolean callWaiting,
            boolean ignoresSetup) {
        this.context = context;
        this.speech = new CallSpeech(context, speech, keys, this::farEndSilent);
        this.keys = keys;
        this.callWaiting = callWaiting;
        this.ignoresSetup = ignoresSetup;
        this.peerHolds = new PeerHolds(context);
        this.connection = new CallConnection(context, services, () -> refused(RejectCause.NETWORK_FAILURE));
        this.second = new SecondCall(context, this::heldEnded, peerHolds::ended);
        hold = new CallHold(context, this, second);
        machine = new StateMachine<>(MobileCallTable.TABLE, context.identity().number(), this::perform);
    }

    public MobileCallState state() {
        return machine.state();
    }

    public Optional<Msisdn> peer() {
        return peer;
    }

    /** As in the messages sent. */
    TransactionIdentifier transaction() {
        return transaction;
    }

    /**
     * Begins a call, or queues it after the one being cleared. @return false if a call is under way or being
     * retrieved
     */
    public boolean dial(Msisdn number) {
        if (MobileCallTable.CLEARING.contains(state()) && next.isEmpty()) {
            next = Optional.of(number);
            if (state() == MobileCallState.DISCONNECT_INDICATION) {
                fire(MobileCallEvent.CLEAR);
            }
            return true;
        }
        return state() == MobileCallState.NULL && !hold.isRetrieving() && begin(number);
    }

    private boolean begin(Msisdn number) {
        peer = Optional.of(number);
        transaction = connection.freeTransaction(second);
        connection.use(number.isEmergency() ? ServiceType.EMERGENCY_CALL : ServiceType.MOBILE_ORIGINATED_CALL);
        fire(MobileCallEvent.DIAL);
        connection.begin();
        return true;
    }

    /** Hides the own number in the next dialled call. */
    public void hideNumber(boolean hides) {
        connection.hideNumber(hides);
    }

    /** Continues or ends a call that waits for service once registration has succeeded or was refused. */
    public void checkService() {
        connection.check();
    }

    public boolean answer() {
        return fire(MobileCallEvent.ANSWER);
    }

    /** Reports after this time that the answer is due, unless the call is answered or ends before. */
    public void remindToAnswer(long nanos) {
        if (state() == MobileCallState.CALL_RECEIVED) {
            context.timers().start(StationTimer.ANSWER, nanos, () -> report(new StationEvent.AnswerDue()));
        }
    }

    /** Ends the call and reports cause 16; a ringing call is rejected with cause 21. @return false if there is none */
    public boolean hangUp() {
        boolean ringing = state() == MobileCallState.CALL_RECEIVED;
        return clear(ringing ? Cause.CALL_REJECTED : Cause.NORMAL_CALL_CLEARING, Cause.NORMAL_CALL_CLEARING);
    }

    public boolean clear(Cause cause) {
        return clear(cause, cause);
    }

    private boolean clear(Cause sent, Cause reported) {
        if (next.isPresent()) {
            cancelNext(reported);
            return true;
        }
        if (state() == MobileCallState.NULL && second.isHeld()) {
            return second.clear();
        }
        return machine.accepts(MobileCallEvent.CLEAR) && fire(MobileCallEvent.CLEAR, sent, reported);
    }

    private void cancelNext(Cause cause) {
        context.events().add(new StationEvent.Calling(next.orElseThrow()));
        context.events().add(new StationEvent.Released(cause));
        next = Optional.empty();
    }

    /** Rejects the waiting call, or ends the held one. @return false if there is neither */
    public boolean clearSecond() {
        return second.clear();
    }

    /**
     * Holds the active call; the waiting call is then answered, or the held one retrieved. While the current call is
     * being cleared, the held one is retrieved after it.
     *
     * @return false if there is neither an active call nor a held one, or the network has still to answer
     */
    public boolean hold() {
        return hold.request();
    }

    CallHold callHold() {
        return hold;
    }

    /** The other party of one of the calls holds it or has retrieved it. */
    void heldByPeer(TransactionIdentifier received, boolean onHold) {
        TransactionIdentifier own = received.answered();
        if (has(received) || second.isPresent() && second.transaction().equals(own)) {
            peerHolds.told(own, onHold, has(received));
        }
    }

    /** The active call is held: it is no longer the current one. */
    void leave() {
        fire(MobileCallEvent.CALL_HELD);
    }

    /** The held or the answered call becomes the current one. */
    void take(SecondCall.Party party) {
        transaction = party.received().answered();
        peer = party.number();
        fire(party.isHeld() ? MobileCallEvent.CALL_RETRIEVED : MobileCallEvent.ANSWER_WAITING);
        peerHolds.reportOnTake(transaction);
    }

    /** The waiting call becomes the current one, and rings. */
    void ring(SecondCall.Party waiting) {
        ring(waiting.received(), waiting.number(), MobileCallEvent.TAKE_WAITING);
    }

    /** Without a held and a current call the connection is not needed. */
    private void heldEnded() {
        hold.heldEnded();
        if (state() == MobileCallState.NULL) {
            connection.release();
        }
    }

    public void powerOff() {
        if (next.isPresent()) {
            cancelNext(Cause.NORMAL_CALL_CLEARING);
        }
        if (second.isHeld()) {
            second.clear();
        }
        second.end(Cause.NORMAL_CALL_CLEARING);
        fire(MobileCallEvent.POWER_OFF);
    }

    @Override
    public void connected() {
        fire(MobileCallEvent.MM_CONNECTED);
    }

    @Override
    public void refused(RejectCause cause) {
        fire(
                MobileCallEvent.MM_REFUSED,
                switch (cause) {
                    case CONGESTION -> Cause.SWITCHING_EQUIPMENT_CONGESTION;
                    case SERVICE_OPTION_NOT_SUPPORTED -> Cause.SERVICE_NOT_AVAILABLE;
                    default -> Cause.NETWORK_OUT_OF_ORDER;
                });
    }

    /** A call that waits for service requests it again; any other ends. */
    @Override
    public void lost() {
        if (connection.isRunning()) {
            connection.request();
            return;
        }
        second.end(Cause.TEMPORARY_FAILURE);
        fire(MobileCallEvent.RADIO_LOST, Cause.TEMPORARY_FAILURE);
    }

    /** Ends a call without received speech; none is required before the call is active. */
    private void farEndSilent() {
        if (state() == MobileCallState.ACTIVE || state() == MobileCallState.DISCONNECT_INDICATION) {
            clear(Cause.TEMPORARY_FAILURE);
        }
    }

    /** True if messages with this transaction, as received, belong to the call. */
    boolean has(TransactionIdentifier received) {
        return state() != MobileCallState.NULL
                && state() != MobileCallState.MM_CONNECTION_PENDING
                && received.answered().equals(transaction);
    }

    /** SETUP has arrived while there is no call. */
    void offered(TransactionIdentifier received, Optional<Msisdn> caller) {
        ring(received, caller, MobileCallEvent.SETUP);
    }

    private void ring(TransactionIdentifier received, Optional<Msisdn> caller, MobileCallEvent event) {
        transaction = received.answered();
        peer = caller;
        connection.use(ServiceType.MOBILE_ORIGINATED_CALL);
        connection.adopt();
        fire(event);
    }

    /** The network names the answering number, which differs from the dialled one after forwarding. */
    void connectedTo(Msisdn number) {
        peer = peer.filter(dialled -> dialled.plain().equals(number.plain())).or(() -> Optional.of(number));
    }

    void sendStatus(Cause cause) {
        send(new CallControl.Status(transaction, cause, state().code()));
    }

    /** A message has arrived. @return true if the current state accepts it */
    boolean arrived(MobileCallEvent event, Cause cause, boolean inBand) {
        tonesAnnounced = inBand;
        boolean accepted = fire(event, cause);
        tonesAnnounced = false;
        return accepted;
    }

    private boolean fire(MobileCallEvent event) {
        return fire(event, Cause.NORMAL_CALL_CLEARING);
    }

    private boolean fire(MobileCallEvent event, Cause cause) {
        return fire(event, cause, cause);
    }

    private boolean fire(MobileCallEvent event, Cause sent, Cause reported) {
        sentCause = sent;
        reportedCause = reported;
        boolean accepted = machine.fire(event);
        if (accepted && state() == MobileCallState.NULL) {
            keys.end();
            if (event != MobileCallEvent.CALL_HELD) {
                peerHolds.ended(transaction);
            }
            transaction = null;
            peer = Optional.empty();
            if (event != MobileCallEvent.CALL_HELD) {
                hold.activeEnded();
                beginNext();
            }
        }
        return accepted;
    }

    private void beginNext() {
        Optional<Msisdn> number = next;
        next = Optional.empty();
        if (number.isPresent()) {
            begin(number.get());
        } else if (second.isWaiting()) {
            second.take().ifPresent(this::ring);
        }
        hold.retrieveIfAsked();
    }

    SecondCall second() {
        return second;
    }

    boolean ignoresSetup() {
        return ignoresSetup;
    }

    boolean acceptsWaitingCall() {
        return callWaiting && state() == MobileCallState.ACTIVE && !second.isPresent();
    }

    private void perform(MobileCallAction action) {
        switch (action) {
            case REQUEST_CONNECTION -> connection.request();
            case RELEASE_CONNECTION -> releaseConnection();
            case SEND_SETUP -> send(connection.setup(transaction, peer));
            case SEND_CALL_CONFIRMED -> send(new CallControl.CallConfirmed(transaction));
            case SEND_ALERTING -> send(new CallControl.Alerting(transaction));
            case SEND_CONNECT -> send(new CallControl.Connect(transaction));
            case SEND_CONNECT_ACKNOWLEDGE -> send(new CallControl.ConnectAcknowledge(transaction));
            case SEND_DISCONNECT -> send(new CallControl.Disconnect(transaction, sentCause));
            case SEND_RELEASE -> send(new CallControl.Release(transaction, Optional.empty()));
            case SEND_RELEASE_COMPLETE -> send(new CallControl.ReleaseComplete(transaction, Optional.empty()));
            case START_T303 -> start(StationTimer.T303, MobileCallEvent.T303_EXPIRED);
            case START_T305 -> start(StationTimer.T305, MobileCallEvent.T305_EXPIRED);
            case START_T308 -> start(StationTimer.T308, MobileCallEvent.T308_EXPIRED);
            case START_T308_AGAIN -> start(StationTimer.T308, MobileCallEvent.T308_EXPIRED_AGAIN);
            case START_T310 -> start(StationTimer.T310, MobileCallEvent.T310_EXPIRED);
            case START_T313 -> start(StationTimer.T313, MobileCallEvent.T313_EXPIRED);
            case STOP_TIMERS -> context.timers().stop(MobileCallTable.TIMERS);
            case ATTACH_USER -> speech.attach(tonesAnnounced);
            case START_SPEECH -> speech.start(transaction);
            case STOP_SPEECH -> speech.stop();
            case REPORT_CALLING -> report(new StationEvent.Calling(peer.orElseThrow()));
            case REPORT_ALERTED -> report(new StationEvent.CalledPartyAlerted());
            case REPORT_RINGING -> report(new StationEvent.Ringing(peer));
            case REPORT_CONNECTED -> report(new StationEvent.Connected(peer));
            case REPORT_HELD -> report(new StationEvent.CallHeld(peer));
            case REPORT_RETRIEVED -> report(new StationEvent.CallRetrieved(peer));
            case REPORT_RELEASED -> report(new StationEvent.Released(reportedCause));
            case CHECK_COMPATIBILITY -> fire(MobileCallEvent.COMPATIBLE);
            case ALERT_USER -> fire(MobileCallEvent.USER_ALERTED);
            case CHECK_TONES ->
                fire(
                        tonesAnnounced ? MobileCallEvent.TONES_ANNOUNCED : MobileCallEvent.NO_TONES_ANNOUNCED,
                        reportedCause);
        }
    }

    /** The radio connection is kept while a call is held. */
    private void releaseConnection() {
        if (second.isHeld()) {
            connection.withdraw();
        } else {
            connection.release();
        }
    }

    private void start(StationTimer timer, MobileCallEvent expired) {
        context.timers().start(timer, () -> fire(expired, Cause.RECOVERY_ON_TIMER_EXPIRY));
    }

    private void report(StationEvent event) {
        context.events().add(event);
    }

    private void send(CallControl message) {
        context.radio().send(message);
    }
}
