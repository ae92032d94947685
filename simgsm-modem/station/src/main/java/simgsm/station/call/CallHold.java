package simgsm.station.call;

import java.util.Map;
import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.TransactionIdentifier;
import simgsm.state.StateMachine;
import simgsm.station.call.CallHoldTable.CallHoldAction;
import simgsm.station.call.CallHoldTable.CallHoldEvent;
import simgsm.station.call.CallHoldTable.CallHoldState;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationTimer;

/** Holds and retrieves calls of a station; runs by {@link CallHoldTable}. */
final class CallHold {
    private static final Map<Class<? extends CallControl>, CallHoldEvent> ANSWERS = Map.of(
            CallControl.HoldAcknowledge.class, CallHoldEvent.HOLD_ACKNOWLEDGE,
            CallControl.HoldReject.class, CallHoldEvent.HOLD_REJECT,
            CallControl.RetrieveAcknowledge.class, CallHoldEvent.RETRIEVE_ACKNOWLEDGE,
            CallControl.RetrieveReject.class, CallHoldEvent.RETRIEVE_REJECT);

    private final StationContext context;
    private final MobileCall call;
    private final SecondCall second;
    private final StateMachine<CallHoldState, CallHoldEvent, CallHoldAction> machine;
    /** Waiting call to be answered after the hold of the active one, by its transaction as in the messages sent. */
    private Optional<TransactionIdentifier> toAnswer = Optional.empty();
    /** True if the held call follows the one being cleared. */
    private boolean retrievesNext;

    CallHold(StationContext context, MobileCall call, SecondCall second) {
        this.context = context;
        this.call = call;
        this.second = second;
        machine = new StateMachine<>(CallHoldTable.TABLE, context.identity().number(), this::perform);
    }

    /** As {@link MobileCall#hold}. */
    boolean request() {
        if (call.state() == MobileCallState.ACTIVE) {
            return holdActive();
        }
        if (MobileCallTable.CLEARING.contains(call.state()) && second.isHeld()) {
            retrievesNext = true;
            return true;
        }
        return call.state() == MobileCallState.NULL && second.isHeld() && fire(CallHoldEvent.USER_RETRIEVES);
    }

    private boolean holdActive() {
        boolean isAccepted = fire(second.isHeld() ? CallHoldEvent.USER_SWAPS : CallHoldEvent.USER_HOLDS);
        if (isAccepted) {
            toAnswer = second.isWaiting() ? Optional.of(second.transaction()) : Optional.empty();
        }
        return isAccepted;
    }

    private boolean fire(CallHoldEvent event) {
        return machine.accepts(event) && machine.fire(event);
    }

    /** A message of one of the calls has arrived. @return true if it answers HOLD or RETRIEVE */
    boolean answered(CallControl message) {
        CallHoldEvent event = ANSWERS.get(message.getClass());
        if (event != null) {
            machine.fire(machine.state() == CallHoldState.IDLE ? late(event, message.transaction()) : event);
        }
        return event != null;
    }

    /** The event of an answer that arrives after its time-out. */
    private CallHoldEvent late(CallHoldEvent event, TransactionIdentifier received) {
        if (event == CallHoldEvent.HOLD_ACKNOWLEDGE && call.state() == MobileCallState.ACTIVE && call.has(received)) {
            return second.isHeld() ? CallHoldEvent.SWAP_HELD_LATE : CallHoldEvent.HELD_LATE;
        }
        boolean isBack = event == CallHoldEvent.RETRIEVE_ACKNOWLEDGE
                && second.isHeld()
                && second.transaction().equals(received.answered());
        if (isBack) {
            return call.state() == MobileCallState.NULL
                    ? CallHoldEvent.RETRIEVED_LATE
                    : CallHoldEvent.RETRIEVED_IN_VAIN;
        }
        return event;
    }

    /** While the held call is being retrieved, no other call can be held. */
    boolean isRetrieving() {
        return machine.state() == CallHoldState.RETRIEVE_REQUEST;
    }

    /** The current call has ended. */
    void activeEnded() {
        machine.fire(CallHoldEvent.ACTIVE_ENDED);
    }

    void heldEnded() {
        machine.fire(CallHoldEvent.HELD_ENDED);
    }

    /** The current call has ended; another may have replaced it. */
    void retrieveIfAsked() {
        if (retrievesNext && second.isHeld() && call.state() == MobileCallState.NULL) {
            fire(CallHoldEvent.USER_RETRIEVES);
        }
        retrievesNext = false;
    }

    private void perform(CallHoldAction action) {
        switch (action) {
            case SEND_HOLD -> context.radio().send(new CallControl.Hold(call.transaction()));
            case SEND_RETRIEVE -> context.radio().send(new CallControl.Retrieve(second.transaction()));
            case START_TIMER ->
                context.timers().start(StationTimer.CALL_HOLD, () -> machine.fire(CallHoldEvent.EXPIRED));
            case STOP_TIMER -> context.timers().stop(StationTimer.CALL_HOLD);
            case PARK, EXCHANGE -> park();
            case RESUME -> second.take().ifPresent(this::resume);
            case CLEAR_HELD -> second.clear();
            case REPORT_REFUSED -> {
                toAnswer = Optional.empty();
                context.events().add(new StationEvent.HoldRefused());
            }
        }
    }

    /** The active call becomes the held one; the second call, if any, becomes the current one. */
    private void park() {
        SecondCall.Party active = new SecondCall.Party(call.transaction().answered(), call.peer(), true);
        Optional<SecondCall.Party> other = second.take();
        call.leave();
        second.hold(active);
        other.ifPresent(this::resume);
    }

    /** A waiting call rings as the current one, unless the user has asked to answer it. */
    private void resume(SecondCall.Party party) {
        if (party.isHeld() || toAnswer.equals(Optional.of(party.received().answered()))) {
            call.take(party);
        } else {
            call.ring(party);
        }
    }
}
