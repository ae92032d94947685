package simgsm.center.msc;

import java.util.Optional;
import simgsm.abis.IpaFrame;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;
import simgsm.dtmf.ToneSet;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * One mobile's side of a call, as the network sees it: {@link NetworkCallTable} driven by the mobile's messages, by the
 * call, and by the standard's timers.
 */
final class CallLeg implements PagedTransaction {
    /** What the call wants to know of its legs. */
    interface Owner {
        void offered(CallLeg leg);

        void alerting(CallLeg leg);

        void answered(CallLeg leg);

        void active(CallLeg leg);

        /** The leg is being cleared, not by the owner's wish. */
        void cleared(CallLeg leg, Cause cause);

        /** The leg that hears what this one says, or null while nobody does. */
        CallLeg listenerOf(CallLeg leg);
    }

    private final Link link;
    private final TransactionIdentifier transaction;
    private final Timers timers;
    private final Owner owner;
    private final Optional<Msisdn> calling;

    private NetworkCallState state = NetworkCallState.NULL;
    private Timer guard;
    private boolean releaseRepeated;
    private Cause cause = Cause.NORMAL_CALL_CLEARING;
    private Optional<Cause> sentCause = Optional.empty();
    /** What the mobile hears of the network itself; a called mobile hears nothing. */
    private final NetworkTones networkTones;
    /** Whether it has been told so, in this state. */
    private boolean tonesAnnounced;
    /** Null until the mobile signals its first key. */
    private ToneSender tones;

    /**
     * @param transaction as the network writes it
     * @param calling who calls, shown to a called mobile; empty on the caller's own leg
     * @param toneSet of the network's own tones for a caller
     */
    CallLeg(
            Link link,
            TransactionIdentifier transaction,
            Optional<Msisdn> calling,
            Optional<ToneSet> toneSet,
            Timers timers,
            Owner owner) {
        this.link = link;
        this.transaction = transaction;
        this.calling = calling;
        this.timers = timers;
        this.owner = owner;
        this.networkTones = new NetworkTones(toneSet, link, timers);
    }

    Link link() {
        return link;
    }

    TransactionIdentifier transaction() {
        return transaction;
    }

    NetworkCallState state() {
        return state;
    }

    CallLeg listener() {
        return owner.listenerOf(this);
    }

    // From the call.

    void page() {
        happen(NetworkCallEvent.PAGE);
        if (state == NetworkCallState.MM_CONNECTION_PENDING) {
            link.paging.request(this);
        }
    }

    void proceed() {
        happen(NetworkCallEvent.PROCEED);
    }

    void alert() {
        happen(NetworkCallEvent.ALERT);
    }

    void answer() {
        happen(NetworkCallEvent.ANSWER);
    }

    /** Ends this leg for a reason that lies elsewhere. */
    void clear(Cause why) {
        happen(NetworkCallEvent.CLEAR, why, Optional.of(why));
    }

    // From below.

    @Override
    public void radioConnected() {
        happen(NetworkCallEvent.RADIO_CONNECTED);
    }

    @Override
    public void pagingFailed() {
        happen(NetworkCallEvent.PAGING_FAILED, Cause.DESTINATION_OUT_OF_ORDER, Optional.empty());
    }

    void linkLost() {
        boolean neverReached = calling.isPresent() && !state.speaks();
        Cause told = neverReached ? Cause.DESTINATION_OUT_OF_ORDER : Cause.TEMPORARY_FAILURE;
        happen(NetworkCallEvent.LINK_LOST, told, Optional.empty());
    }

    /** Takes a message of this transaction; one that does not fit the state is answered with STATUS. */
    void receive(CallControl message) {
        if (message instanceof CallControl.StatusEnquiry) {
            sendStatus(Cause.RESPONSE_TO_STATUS_ENQUIRY);
        } else if (message instanceof CallControl.StartDtmf start) {
            tones().start(start.key());
        } else if (message instanceof CallControl.StopDtmf) {
            tones().stop();
        } else if (message instanceof CallControl.Status status) {
            receiveStatus(status);
        } else if (!receiveForTable(message)) {
            sendStatus(Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
    }

    private ToneSender tones() {
        if (tones == null) {
            tones = new ToneSender(this, timers);
        }
        return tones;
    }

    /** What the other party is to hear in the place of this speech frame: mostly itself; null if nothing. */
    IpaFrame audible(IpaFrame speech) {
        return tones == null ? speech : tones.inPlaceOf(speech);
    }

    void sendStatus(Cause why) {
        link.send(new CallControl.Status(transaction, why, state.code()));
    }

    private void receiveStatus(CallControl.Status status) {
        if (status.callState() == NetworkCallState.NULL.code()) {
            happen(NetworkCallEvent.STATUS_NULL_RECEIVED, status.cause(), Optional.empty());
        }
    }

    private boolean receiveForTable(CallControl message) {
        if (message instanceof CallControl.Disconnect disconnect) {
            return happen(NetworkCallEvent.DISCONNECT_RECEIVED, disconnect.cause(), Optional.empty());
        }
        if (message instanceof CallControl.Release release) {
            return happen(NetworkCallEvent.RELEASE_RECEIVED, orNormal(release.cause()), Optional.empty());
        }
        if (message instanceof CallControl.ReleaseComplete complete) {
            return happen(NetworkCallEvent.RELEASE_COMPLETE_RECEIVED, orNormal(complete.cause()), Optional.empty());
        }
        return eventOf(message).map(this::happen).orElse(false);
    }

    private static Cause orNormal(Optional<Cause> cause) {
        return cause.orElse(Cause.NORMAL_CALL_CLEARING);
    }

    private static Optional<NetworkCallEvent> eventOf(CallControl message) {
        if (message instanceof CallControl.Setup) {
            return Optional.of(NetworkCallEvent.SETUP_RECEIVED);
        }
        if (message instanceof CallControl.CallConfirmed) {
            return Optional.of(NetworkCallEvent.CALL_CONFIRMED_RECEIVED);
        }
        if (message instanceof CallControl.Alerting) {
            return Optional.of(NetworkCallEvent.ALERTING_RECEIVED);
        }
        if (message instanceof CallControl.Connect) {
            return Optional.of(NetworkCallEvent.CONNECT_RECEIVED);
        }
        if (message instanceof CallControl.ConnectAcknowledge) {
            return Optional.of(NetworkCallEvent.CONNECT_ACKNOWLEDGE_RECEIVED);
        }
        return Optional.empty();
    }

    // The machine.

    private boolean happen(NetworkCallEvent event) {
        return happen(event, Cause.NORMAL_CALL_CLEARING, Optional.empty());
    }

    /**
     * @param told what the owner is told if the leg clears
     * @param sent what the mobile is told if the leg clears; empty when it told us
     * @return whether the state allows the event
     */
    private boolean happen(NetworkCallEvent event, Cause told, Optional<Cause> sent) {
        Optional<NetworkCallTable.Transition> row = NetworkCallTable.of(state, event);
        if (row.isEmpty()) {
            return false;
        }
        NetworkCallState before = state;
        state = row.get().next();
        if (!before.isClearing()) {
            cause = told;
            sentCause = sent;
        }
        if (state != before) {
            tonesAnnounced = announcesTones(before);
        }
        if (state != before || !row.get().actions().isEmpty()) {
            restartGuard();
        }
        if (tones != null && !state.speaks()) {
            tones.end();
        }
        link.callLegChanged(this);
        row.get().actions().forEach(this::perform);
        // What was done may have led on to another state already.
        if (state != before && state == row.get().next()) {
            networkTones.follow(state, cause, tonesAnnounced);
        }
        return true;
    }

    /** A caller is told that the network lets him hear how his call goes: only while it is not connected. */
    private boolean announcesTones(NetworkCallState before) {
        return state == NetworkCallState.CALL_DELIVERED && networkTones.ring()
                || state == NetworkCallState.DISCONNECT_INDICATION
                        && (before == NetworkCallState.CALL_PROCEEDING || before == NetworkCallState.CALL_DELIVERED)
                        && networkTones.has(cause);
    }

    private void restartGuard() {
        timers.cancel(guard);
        guard = state.guard(tonesAnnounced)
                .map(timer -> timers.start(timer.nanos(), () -> expired(timer)))
                .orElse(null);
    }

    private void expired(NetworkCallTimer timer) {
        NetworkCallEvent event = timer.expiry();
        if (event == NetworkCallEvent.T308_EXPIRED && releaseRepeated) {
            event = NetworkCallEvent.T308_EXPIRED_AGAIN;
        }
        releaseRepeated |= timer == NetworkCallTimer.T308;
        happen(event, timer.toldCause(), Optional.of(Cause.RECOVERY_ON_TIMER_EXPIRY));
    }

    private void perform(NetworkCallAction action) {
        switch (action) {
            case SEND_SETUP ->
                link.send(new CallControl.Setup(transaction, waitingSignal(), calling, Optional.empty()));
            case SEND_CALL_PROCEEDING -> link.send(new CallControl.CallProceeding(transaction));
            case SEND_ALERTING -> link.send(new CallControl.Alerting(transaction, tonesAnnounced));
            case SEND_CONNECT -> link.send(new CallControl.Connect(transaction));
            case SEND_CONNECT_ACKNOWLEDGE -> link.send(new CallControl.ConnectAcknowledge(transaction));
            case SEND_DISCONNECT ->
                link.send(new CallControl.Disconnect(transaction, sentCause.orElse(cause), tonesAnnounced));
            case SEND_RELEASE -> link.send(new CallControl.Release(transaction, sentCause));
            case SEND_RELEASE_COMPLETE -> link.send(new CallControl.ReleaseComplete(transaction, sentCause));
            case TELL_OFFERED -> owner.offered(this);
            case TELL_ALERTING -> owner.alerting(this);
            case TELL_ANSWERED -> owner.answered(this);
            case TELL_ACTIVE -> owner.active(this);
            case TELL_CLEARED -> owner.cleared(this, cause);
        }
    }

    /** Who is in a call already is told that this one waits (TS 24.083, 1). */
    private Optional<CallControl.Signal> waitingSignal() {
        boolean isSecond = link.callLegs.stream()
                .anyMatch(leg -> leg != this && !leg.state().isClearing());
        return isSecond ? Optional.of(CallControl.Signal.CALL_WAITING) : Optional.empty();
    }

    @Override
    public String toString() {
        return link.name() + " " + state;
    }
}
