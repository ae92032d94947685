package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Type;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolErrorAnswers;
import simgsm.air.ProtocolViolation;
import simgsm.air.RejectCause;
import simgsm.air.TransactionIdentifier;

/** The one call of a station: performs what {@link CallTable} says. */
final class Call implements ServiceRequests.User {
    /** Messages whose meaning depends on the state alone. */
    private static final Map<Class<? extends CallControl>, CallEvent> EVENTS = Map.of(
            CallControl.CallProceeding.class, CallEvent.CALL_PROCEEDING,
            CallControl.Progress.class, CallEvent.PROGRESS,
            CallControl.Alerting.class, CallEvent.ALERTING,
            CallControl.Connect.class, CallEvent.CONNECT,
            CallControl.ConnectAcknowledge.class, CallEvent.CONNECT_ACKNOWLEDGE,
            CallControl.Disconnect.class, CallEvent.DISCONNECT,
            CallControl.Release.class, CallEvent.RELEASE,
            CallControl.ReleaseComplete.class, CallEvent.RELEASE_COMPLETE);

    private static final int TRANSACTIONS = 7;

    private final StationParts parts;
    private final ServiceRequests services;
    private final SpeechPath speech;
    private CallState state = CallState.NULL;
    /** As our messages carry it; null in state NULL. */
    private TransactionIdentifier transaction;

    private int nextTransaction;
    private Optional<Msisdn> peer = Optional.empty();
    /** What our clearing message says. */
    private Cause sentCause = Cause.NORMAL_CALL_CLEARING;
    /** What the user is told. */
    private Cause toldCause = Cause.NORMAL_CALL_CLEARING;

    private boolean releasedAgain;
    /** Dialled while the call before was still being cleared. */
    private Optional<Msisdn> next = Optional.empty();

    Call(StationParts parts, ServiceRequests services, SpeechPath speech) {
        this.parts = parts;
        this.services = services;
        this.speech = speech;
    }

    CallState state() {
        return state;
    }

    Optional<Msisdn> peer() {
        return peer;
    }

    /** While an old call is still being cleared, the new one waits for its end: the user has let go of it already. */
    boolean dial(Msisdn number) {
        if (CallTable.CLEARING.contains(state) && next.isEmpty()) {
            next = Optional.of(number);
            return true;
        }
        return state == CallState.NULL && begin(number);
    }

    private boolean begin(Msisdn number) {
        peer = Optional.of(number);
        transaction = new TransactionIdentifier(nextTransaction, false);
        nextTransaction = (nextTransaction + 1) % TRANSACTIONS;
        happens(CallEvent.DIAL);
        if (!services.isPossible()) {
            refused(RejectCause.NETWORK_FAILURE);
        }
        return true;
    }

    boolean answer() {
        return happens(CallEvent.ANSWER);
    }

    /** A ringing call that is hung up is rejected, and so its caller hears; the user's own hang-up is 16 all the same. */
    boolean hangUp() {
        boolean ringing = state == CallState.CALL_RECEIVED;
        return clear(ringing ? Cause.CALL_REJECTED : Cause.NORMAL_CALL_CLEARING, Cause.NORMAL_CALL_CLEARING);
    }

    boolean clear(Cause cause) {
        return clear(cause, cause);
    }

    private boolean clear(Cause sent, Cause told) {
        if (next.isPresent()) {
            giveUpNext(told);
            return true;
        }
        return CallTable.ROWS.row(state, CallEvent.CLEAR).isPresent() && happens(CallEvent.CLEAR, sent, told);
    }

    private void giveUpNext(Cause cause) {
        Msisdn number = next.orElseThrow();
        next = Optional.empty();
        parts.notifications().add(listener -> listener.calling(number));
        parts.notifications().add(listener -> listener.released(cause));
    }

    void powerOff() {
        if (next.isPresent()) {
            giveUpNext(Cause.NORMAL_CALL_CLEARING);
        }
        happens(CallEvent.POWER_OFF, Cause.NORMAL_CALL_CLEARING);
    }

    @Override
    public void connected() {
        happens(CallEvent.MM_CONNECTED);
    }

    @Override
    public void refused(RejectCause cause) {
        happens(
                CallEvent.MM_REFUSED,
                switch (cause) {
                    case CONGESTION -> Cause.SWITCHING_EQUIPMENT_CONGESTION;
                    case SERVICE_OPTION_NOT_SUPPORTED -> Cause.SERVICE_NOT_AVAILABLE;
                    default -> Cause.NETWORK_OUT_OF_ORDER;
                });
    }

    @Override
    public void lost() {
        happens(CallEvent.RADIO_LOST, Cause.TEMPORARY_FAILURE);
    }

    void expired(CallEvent timer) {
        happens(timer, Cause.RECOVERY_ON_TIMER_EXPIRY);
    }

    void t308Expired() {
        happens(releasedAgain ? CallEvent.T308_EXPIRED_AGAIN : CallEvent.T308_EXPIRED);
    }

    void arrived(CallControl message) {
        if (message instanceof CallControl.Setup setup) {
            offered(setup);
        } else if (isOurs(message.transaction())) {
            arrivedInCall(message);
        } else {
            arrivedOutsideCall(message);
        }
    }

    /** A message that broke the protocol (TS 24.008, 8): one that clears still clears, all others are answered. */
    void violated(ProtocolViolation violation, Layer3Header header) {
        TransactionIdentifier received = header.transaction().orElseThrow();
        Optional<CallControl> clearing =
                header.type().flatMap(type -> clearing(type, received, violation.statusCause()));
        if (clearing.isPresent()) {
            arrived(clearing.get());
        } else if (isOurs(received) || header.type().equals(Optional.of(Layer3Type.SETUP))) {
            ProtocolErrorAnswers.to(violation, state.code()).forEach(parts.radio()::send);
        } else {
            refuse(received, Cause.INVALID_TRANSACTION_IDENTIFIER);
        }
    }

    private static Optional<CallControl> clearing(Layer3Type type, TransactionIdentifier received, Cause cause) {
        return Optional.ofNullable(
                switch (type) {
                    case DISCONNECT -> new CallControl.Disconnect(received, cause);
                    case RELEASE -> new CallControl.Release(received, Optional.of(cause));
                    case RELEASE_COMPLETE -> new CallControl.ReleaseComplete(received, Optional.of(cause));
                    default -> null;
                });
    }

    private boolean isOurs(TransactionIdentifier received) {
        return state != CallState.NULL
                && state != CallState.MM_CONNECTION_PENDING
                && received.answered().equals(transaction);
    }

    private void offered(CallControl.Setup setup) {
        if (setup.transaction().fromOtherSide() || isOurs(setup.transaction())) {
            parts.log().trace(Level.DEBUG, "SETUP of a known or foreign transaction ignored");
        } else if (state != CallState.NULL) {
            refuse(setup.transaction(), Cause.USER_BUSY);
        } else {
            transaction = setup.transaction().answered();
            peer = setup.calling();
            services.adopt(ServiceType.MOBILE_ORIGINATED_CALL);
            happens(CallEvent.SETUP);
        }
    }

    /** TS 24.008, 8.3.2: a transaction that we do not know is released, unless that is what the message does itself. */
    private void arrivedOutsideCall(CallControl message) {
        if (!(message instanceof CallControl.ReleaseComplete)) {
            refuse(message.transaction(), Cause.INVALID_TRANSACTION_IDENTIFIER);
        }
    }

    private void refuse(TransactionIdentifier received, Cause cause) {
        parts.radio().send(new CallControl.ReleaseComplete(received.answered(), Optional.of(cause)));
    }

    private void arrivedInCall(CallControl message) {
        if (message instanceof CallControl.StatusEnquiry) {
            sendStatus(Cause.RESPONSE_TO_STATUS_ENQUIRY);
            return;
        }
        if (message instanceof CallControl.Status status) {
            statusArrived(status);
            return;
        }
        CallEvent event = EVENTS.get(message.getClass());
        if (event == null) {
            sendStatus(Cause.MESSAGE_TYPE_NON_EXISTENT);
        } else if (!happens(event, causeIn(message))) {
            sendStatus(Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
    }

    private void statusArrived(CallControl.Status status) {
        parts.log().trace(Level.INFO, "STATUS {0} in U{1}", status.cause().title(), status.callState());
        if (status.callState() == CallState.NULL.code()) {
            happens(CallEvent.STATUS_NULL, status.cause());
        }
    }

    private void sendStatus(Cause cause) {
        parts.radio().send(new CallControl.Status(transaction, cause, state.code()));
    }

    private static Cause causeIn(CallControl message) {
        if (message instanceof CallControl.Disconnect disconnect) {
            return disconnect.cause();
        }
        if (message instanceof CallControl.Release release) {
            return release.cause().orElse(Cause.NORMAL_UNSPECIFIED);
        }
        if (message instanceof CallControl.ReleaseComplete complete) {
            return complete.cause().orElse(Cause.NORMAL_UNSPECIFIED);
        }
        return Cause.NORMAL_CALL_CLEARING;
    }

    private boolean happens(CallEvent event) {
        return happens(event, Cause.NORMAL_CALL_CLEARING);
    }

    private boolean happens(CallEvent event, Cause cause) {
        return happens(event, cause, cause);
    }

    /** @return whether the present state accepts the event */
    private boolean happens(CallEvent event, Cause sent, Cause told) {
        var row = CallTable.ROWS.row(state, event);
        if (row.isEmpty()) {
            parts.log().refused(state, event);
            return false;
        }
        parts.log().trace(Level.DEBUG, "{0} {1} -> {2}", state, event, row.get().next());
        state = row.get().next();
        sentCause = sent;
        toldCause = told;
        row.get().actions().forEach(this::perform);
        if (state == CallState.NULL) {
            transaction = null;
            peer = Optional.empty();
            beginNext();
        }
        return true;
    }

    private void beginNext() {
        Optional<Msisdn> number = next;
        next = Optional.empty();
        number.ifPresent(this::begin);
    }

    private void perform(CallAction action) {
        switch (action) {
            case REQUEST_CONNECTION -> services.request(ServiceType.MOBILE_ORIGINATED_CALL);
            case RELEASE_CONNECTION -> services.release(ServiceType.MOBILE_ORIGINATED_CALL);
            case SEND_SETUP -> send(new CallControl.Setup(transaction, Optional.empty(), peer));
            case SEND_CALL_CONFIRMED -> send(new CallControl.CallConfirmed(transaction));
            case SEND_ALERTING -> send(new CallControl.Alerting(transaction));
            case SEND_CONNECT -> send(new CallControl.Connect(transaction));
            case SEND_CONNECT_ACKNOWLEDGE -> send(new CallControl.ConnectAcknowledge(transaction));
            case SEND_DISCONNECT -> send(new CallControl.Disconnect(transaction, sentCause));
            case SEND_RELEASE -> send(new CallControl.Release(transaction, Optional.empty()));
            case SEND_RELEASE_COMPLETE -> send(new CallControl.ReleaseComplete(transaction, Optional.empty()));
            case START_T303 -> parts.timers().start(StationTimer.T303);
            case START_T305 -> parts.timers().start(StationTimer.T305);
            case START_T308 -> startT308(false);
            case START_T308_AGAIN -> startT308(true);
            case START_T310 -> parts.timers().start(StationTimer.T310);
            case START_T313 -> parts.timers().start(StationTimer.T313);
            case STOP_TIMERS -> stopTimers();
            case START_SPEECH -> speech.start();
            case STOP_SPEECH -> speech.stop();
            case CHECK_COMPATIBILITY -> happens(CallEvent.COMPATIBLE);
            case ALERT_USER -> happens(CallEvent.USER_ALERTED);
            case LISTEN_FOR_TONES -> happens(CallEvent.NOTHING_TO_HEAR);
            default -> tell(action);
        }
    }

    private void tell(CallAction action) {
        Optional<Msisdn> who = peer;
        Cause cause = toldCause;
        switch (action) {
            case TELL_CALLING ->
                who.ifPresent(number -> parts.notifications().add(listener -> listener.calling(number)));
            case TELL_ALERTING -> parts.notifications().add(StationListener::alerting);
            case TELL_RINGING -> parts.notifications().add(listener -> listener.ringing(who));
            case TELL_CONNECTED -> parts.notifications().add(listener -> listener.connected(who));
            case TELL_RELEASED -> parts.notifications().add(listener -> listener.released(cause));
            default -> throw new IllegalArgumentException("nothing to tell in " + action);
        }
    }

    private void send(CallControl message) {
        parts.radio().send(message);
    }

    private void startT308(boolean again) {
        releasedAgain = again;
        parts.timers().start(StationTimer.T308);
    }

    private void stopTimers() {
        parts.timers().stop(StationTimer.T303);
        parts.timers().stop(StationTimer.T305);
        parts.timers().stop(StationTimer.T308);
        parts.timers().stop(StationTimer.T310);
        parts.timers().stop(StationTimer.T313);
    }
}
