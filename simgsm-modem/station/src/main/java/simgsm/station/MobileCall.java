package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.TransactionIdentifier;

/** The one call of a station: performs what {@link MobileCallTable} says. */
final class MobileCall implements ServiceRequests.User {
    private static final int TRANSACTIONS = 7;

    private final StationParts parts;
    private final ServiceRequests services;
    private final SpeechPath speech;
    private final KeySignalling keys;
    private final WaitingCall waiting;
    private MobileCallState state = MobileCallState.NULL;
    /** As our messages carry it; null in state NULL. */
    private TransactionIdentifier transaction;

    private int nextTransaction;
    private Optional<Msisdn> peer = Optional.empty();
    /** What our clearing message says. */
    private Cause sentCause = Cause.NORMAL_CALL_CLEARING;
    /** What the user is told. */
    private Cause toldCause = Cause.NORMAL_CALL_CLEARING;

    private boolean releasedAgain;
    /** Whether the message that is being obeyed announces tones of the network's own. */
    private boolean tonesAnnounced;
    /** Whether the network's tones are heard in the place of our own. */
    private boolean hearsNetwork;

    /** Dialled while the call before was still being cleared. */
    private Optional<Msisdn> next = Optional.empty();

    MobileCall(StationParts parts, ServiceRequests services, SpeechPath speech, KeySignalling keys) {
        this.parts = parts;
        this.services = services;
        this.speech = speech;
        this.keys = keys;
        this.waiting = new WaitingCall(parts);
    }

    MobileCallState state() {
        return state;
    }

    Optional<Msisdn> peer() {
        return peer;
    }

    /** While an old call is still being cleared, the new one waits for its end: the user has let go of it already. */
    boolean dial(Msisdn number) {
        if (MobileCallTable.CLEARING.contains(state) && next.isEmpty()) {
            next = Optional.of(number);
            if (state == MobileCallState.DISCONNECT_INDICATION) {
                happens(MobileCallEvent.CLEAR);
            }
            return true;
        }
        return state == MobileCallState.NULL && begin(number);
    }

    private boolean begin(Msisdn number) {
        peer = Optional.of(number);
        transaction = new TransactionIdentifier(nextTransaction, false);
        nextTransaction = (nextTransaction + 1) % TRANSACTIONS;
        happens(MobileCallEvent.DIAL);
        if (!services.isThere()) {
            parts.timers().start(StationTimer.CALL_WAIT);
            lookAtService();
        }
        return true;
    }

    /** Service may have come, or been refused, since: what waits for it hears. */
    void lookAtService() {
        if (!waitsForService()) {
            return;
        }
        if (services.isThere()) {
            parts.timers().stop(StationTimer.CALL_WAIT);
        } else if (services.isRefused()) {
            refused(RejectCause.NETWORK_FAILURE);
        }
    }

    private boolean waitsForService() {
        return parts.timers().isRunning(StationTimer.CALL_WAIT);
    }

    void waitExpired() {
        refused(RejectCause.NETWORK_FAILURE);
    }

    boolean answer() {
        return happens(MobileCallEvent.ANSWER);
    }

    /** A ringing call that is hung up is rejected, and so its caller hears; the user's own hang-up is 16 all the same. */
    boolean hangUp() {
        boolean ringing = state == MobileCallState.CALL_RECEIVED;
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
        return MobileCallTable.ROWS.row(state, MobileCallEvent.CLEAR).isPresent()
                && happens(MobileCallEvent.CLEAR, sent, told);
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
        waiting.over();
        happens(MobileCallEvent.POWER_OFF, Cause.NORMAL_CALL_CLEARING);
    }

    @Override
    public void connected() {
        happens(MobileCallEvent.MM_CONNECTED);
    }

    @Override
    public void refused(RejectCause cause) {
        happens(
                MobileCallEvent.MM_REFUSED,
                switch (cause) {
                    case CONGESTION -> Cause.SWITCHING_EQUIPMENT_CONGESTION;
                    case SERVICE_OPTION_NOT_SUPPORTED -> Cause.SERVICE_NOT_AVAILABLE;
                    default -> Cause.NETWORK_OUT_OF_ORDER;
                });
    }

    /** A call that still waits for a network does not mind that one could not be reached, and asks the next. */
    @Override
    public void lost() {
        if (waitsForService()) {
            services.request(ServiceType.MOBILE_ORIGINATED_CALL);
            return;
        }
        waiting.over();
        happens(MobileCallEvent.RADIO_LOST, Cause.TEMPORARY_FAILURE);
    }

    /** Whether somebody is to be heard at all times; a far end that rings may say nothing. */
    boolean expectsSpeech() {
        return state == MobileCallState.ACTIVE || state == MobileCallState.DISCONNECT_INDICATION;
    }

    void expired(MobileCallEvent timer) {
        happens(timer, Cause.RECOVERY_ON_TIMER_EXPIRY);
    }

    void t308Expired() {
        happens(releasedAgain ? MobileCallEvent.T308_EXPIRED_AGAIN : MobileCallEvent.T308_EXPIRED);
    }

    /** Whether the call's own messages carry this transaction, as it is received. */
    boolean has(TransactionIdentifier received) {
        return state != MobileCallState.NULL
                && state != MobileCallState.MM_CONNECTION_PENDING
                && received.answered().equals(transaction);
    }

    /** Another calls. */
    void offered(TransactionIdentifier received, Optional<Msisdn> caller) {
        transaction = received.answered();
        peer = caller;
        services.adopt(ServiceType.MOBILE_ORIGINATED_CALL);
        happens(MobileCallEvent.SETUP);
    }

    void sendStatus(Cause cause) {
        send(new CallControl.Status(transaction, cause, state.code()));
    }

    private boolean happens(MobileCallEvent event) {
        return happens(event, Cause.NORMAL_CALL_CLEARING);
    }

    /** A message has come. @return whether the present state accepts it */
    boolean arrived(MobileCallEvent event, Cause cause, boolean inBand) {
        tonesAnnounced = inBand;
        boolean accepted = happens(event, cause);
        tonesAnnounced = false;
        return accepted;
    }

    private boolean happens(MobileCallEvent event, Cause cause) {
        return happens(event, cause, cause);
    }

    private boolean happens(MobileCallEvent event, Cause sent, Cause told) {
        var row = MobileCallTable.ROWS.row(state, event);
        if (row.isEmpty()) {
            parts.log().refused(state, event);
            return false;
        }
        parts.log().trace(Level.DEBUG, "{0} {1} -> {2}", state, event, row.get().next());
        state = row.get().next();
        sentCause = sent;
        toldCause = told;
        row.get().actions().forEach(this::perform);
        if (state == MobileCallState.NULL) {
            keys.end();
            transaction = null;
            peer = Optional.empty();
            beginNext();
        }
        return true;
    }

    private void beginNext() {
        Optional<Msisdn> number = next;
        next = Optional.empty();
        if (number.isPresent()) {
            begin(number.get());
        } else {
            waiting.take().ifPresent(this::ringWaiting);
        }
    }

    private void ringWaiting(WaitingCall.Offer offer) {
        transaction = offer.received().answered();
        peer = offer.caller();
        services.adopt(ServiceType.MOBILE_ORIGINATED_CALL);
        happens(MobileCallEvent.TAKE_WAITING);
    }

    WaitingCall waiting() {
        return waiting;
    }

    /** Whether a second call may wait for the end of this one. */
    boolean letsWait() {
        return state == MobileCallState.ACTIVE
                && !waiting.isThere()
                && parts.notifications().ask(StationListener::takesWaitingCalls);
    }

    private void perform(MobileCallAction action) {
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
            case ATTACH_USER -> attachUser();
            case START_SPEECH -> startSpeech();
            case STOP_SPEECH -> stopSpeech();
            case CHECK_COMPATIBILITY -> happens(MobileCallEvent.COMPATIBLE);
            case ALERT_USER -> happens(MobileCallEvent.USER_ALERTED);
            case LISTEN_FOR_TONES -> listenForTones();
            default -> tell(action);
        }
    }

    private void listenForTones() {
        happens(tonesAnnounced ? MobileCallEvent.TONES_TO_HEAR : MobileCallEvent.NOTHING_TO_HEAR, toldCause);
    }

    private void attachUser() {
        if (tonesAnnounced) {
            speech.start();
            hearNetwork(true);
        }
    }

    private void hearNetwork(boolean does) {
        if (hearsNetwork != does) {
            hearsNetwork = does;
            parts.notifications().add(listener -> listener.networkTones(does));
        }
    }

    private void startSpeech() {
        hearNetwork(false);
        speech.start();
        keys.begin(transaction);
    }

    private void stopSpeech() {
        speech.stop();
        keys.end();
        hearNetwork(false);
    }

    private void tell(MobileCallAction action) {
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
        parts.timers().stop(StationTimer.CALL_WAIT);
        parts.timers().stop(StationTimer.T303);
        parts.timers().stop(StationTimer.T305);
        parts.timers().stop(StationTimer.T308);
        parts.timers().stop(StationTimer.T310);
        parts.timers().stop(StationTimer.T313);
    }
}
