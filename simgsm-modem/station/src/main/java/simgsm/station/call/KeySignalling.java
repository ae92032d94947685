package simgsm.station.call;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.TransactionIdentifier;
import simgsm.dtmf.DtmfKey;
import simgsm.state.StateMachine;
import simgsm.station.call.KeySignallingTable.KeySignallingAction;
import simgsm.station.call.KeySignallingTable.KeySignallingEvent;
import simgsm.station.call.KeySignallingTable.KeySignallingState;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationTimer;

/**
 * Sends keys as START DTMF and STOP DTMF, one after the other, paced by the network's acknowledgements; runs by
 * {@link KeySignallingTable}. Keys wait until the call is active.
 */
public final class KeySignalling {
    private static final class Press {
        final DtmfKey key;
        final long nanos;
        boolean held;

        Press(DtmfKey key, long millis, boolean held) {
            this.key = key;
            this.nanos = Math.max(TimeUnit.MILLISECONDS.toNanos(millis), StationTimer.KEY.nanos());
            this.held = held;
        }
    }

    private final StationContext context;
    private final StateMachine<KeySignallingState, KeySignallingEvent, KeySignallingAction> machine;
    /** The first key is being sent, unless the state is IDLE or PAUSING. */
    private final Deque<Press> queue = new ArrayDeque<>();

    /** Transaction of the active call; null without one. */
    private TransactionIdentifier transaction;

    private Cause refusal = Cause.SERVICE_NOT_AVAILABLE;

    public KeySignalling(StationContext context) {
        this.context = context;
        machine =
                new StateMachine<>(KeySignallingTable.TABLE, context.identity().number(), this::perform);
    }

    /** The call has become active. */
    void begin(TransactionIdentifier ofCall) {
        transaction = ofCall;
        sendNext();
    }

    /** The call is no longer active. */
    void end() {
        transaction = null;
        machine.fire(KeySignallingEvent.CALL_ENDED);
    }

    /** Queues a key. @param millis length of its tone, 70 at least */
    public void press(DtmfKey key, int millis) {
        add(new Press(key, millis, false));
    }

    /** Queues a key that sounds until {@link #letGo}; a held key is released first. */
    public void hold(DtmfKey key) {
        letGo();
        add(new Press(key, 0, true));
    }

    /** Releases the held key, if any. */
    public void letGo() {
        if (!queue.isEmpty() && queue.getLast().held) {
            queue.getLast().held = false;
            stopIfOver();
        }
    }

    private void add(Press press) {
        queue.add(press);
        sendNext();
    }

    private void sendNext() {
        if (transaction != null && machine.state() == KeySignallingState.IDLE && !queue.isEmpty()) {
            machine.fire(KeySignallingEvent.NEXT);
        }
    }

    /** @return true if the message answers START DTMF or STOP DTMF; a late answer is ignored */
    boolean arrived(CallControl message) {
        if (message instanceof CallControl.StartDtmfAcknowledge) {
            machine.fire(KeySignallingEvent.START_ACKNOWLEDGED);
        } else if (message instanceof CallControl.StartDtmfReject reject) {
            refused(KeySignallingEvent.START_REJECTED, reject.cause());
        } else if (message instanceof CallControl.StopDtmfAcknowledge) {
            machine.fire(KeySignallingEvent.STOP_ACKNOWLEDGED);
        } else {
            return false;
        }
        return true;
    }

    private void refused(KeySignallingEvent event, Cause cause) {
        refusal = cause;
        machine.fire(event);
    }

    private void stopIfOver() {
        if (machine.state() == KeySignallingState.SOUNDING
                && !queue.element().held
                && !context.timers().isRunning(StationTimer.KEY)) {
            machine.fire(KeySignallingEvent.RELEASED);
        }
    }

    private void perform(KeySignallingAction action) {
        switch (action) {
            case SEND_START ->
                context.radio()
                        .send(new CallControl.StartDtmf(
                                transaction, queue.element().key.symbol()));
            case SEND_STOP -> context.radio().send(new CallControl.StopDtmf(transaction));
            case START_T336 -> start(StationTimer.T336, KeySignallingEvent.T336_EXPIRED);
            case START_T337 -> start(StationTimer.T337, KeySignallingEvent.T337_EXPIRED);
            case START_TONE -> context.timers().start(StationTimer.KEY, queue.element().nanos, this::stopIfOver);
            case START_PAUSE ->
                context.timers().start(StationTimer.KEY, () -> machine.fire(KeySignallingEvent.PAUSE_ENDED));
            case STOP_TIMERS -> context.timers().stop(StationTimer.T336, StationTimer.T337, StationTimer.KEY);
            case REPORT_STARTED -> report(StationEvent.KeyStarted::new);
            case REPORT_STOPPING -> report(StationEvent.KeyStopping::new);
            case REPORT_COMPLETED -> {
                report(StationEvent.KeyCompleted::new);
                queue.remove();
            }
            case REPORT_REFUSED -> context.events().add(new StationEvent.KeysRefused(refusal));
            case DROP_ALL -> queue.clear();
            case SEND_NEXT -> sendNext();
        }
    }

    private void start(StationTimer timer, KeySignallingEvent expired) {
        context.timers().start(timer, () -> refused(expired, Cause.RECOVERY_ON_TIMER_EXPIRY));
    }

    private void report(Function<DtmfKey, StationEvent> event) {
        context.events().add(event.apply(queue.element().key));
    }
}
