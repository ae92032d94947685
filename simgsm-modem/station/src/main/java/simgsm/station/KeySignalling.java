package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.TransactionIdentifier;
import simgsm.dtmf.DtmfKey;

/**
 * Keys that are signalled instead of said: performs what {@link KeyTable} says, one key after the other, paced by the
 * network's acknowledgements. Keys that come before the call is active wait for it.
 */
final class KeySignalling {
    /** A tone's least length and least pause (TS 23.014, 6), with a little to spare. */
    static final int LEAST_TONE_MILLIS = 70;

    static final int PAUSE_MILLIS = 70;

    private static final class Press {
        final DtmfKey key;
        final long nanos;
        boolean held;

        Press(DtmfKey key, long millis, boolean held) {
            this.key = key;
            this.nanos = TimeUnit.MILLISECONDS.toNanos(Math.max(millis, LEAST_TONE_MILLIS));
            this.held = held;
        }
    }

    private final StationParts parts;
    /** The first is the one under way, unless the state is IDLE or PAUSING. */
    private final Deque<Press> queue = new ArrayDeque<>();

    private KeyState state = KeyState.IDLE;
    /** Of the active call; null without one. */
    private TransactionIdentifier transaction;

    private Cause refusal = Cause.SERVICE_NOT_AVAILABLE;

    KeySignalling(StationParts parts) {
        this.parts = parts;
    }

    /** The call is active. */
    void begin(TransactionIdentifier itsTransaction) {
        transaction = itsTransaction;
        sendNext();
    }

    /** The call is active no more. */
    void end() {
        transaction = null;
        happens(KeyEvent.CALL_ENDED);
    }

    void press(DtmfKey key, int millis) {
        add(new Press(key, millis, false));
    }

    /** A key goes down, and another that was down goes up. */
    void hold(DtmfKey key) {
        letGo();
        add(new Press(key, LEAST_TONE_MILLIS, true));
    }

    void letGo() {
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
        if (transaction != null && state == KeyState.IDLE && !queue.isEmpty()) {
            happens(KeyEvent.NEXT);
        }
    }

    /** @return whether the message was one about keys; one that nobody waits for any more is no harm */
    boolean arrived(CallControl message) {
        if (message instanceof CallControl.StartDtmfAcknowledge) {
            happens(KeyEvent.START_ACKNOWLEDGED);
        } else if (message instanceof CallControl.StartDtmfReject reject) {
            refusal = reject.cause();
            happens(KeyEvent.START_REJECTED);
        } else if (message instanceof CallControl.StopDtmfAcknowledge) {
            happens(KeyEvent.STOP_ACKNOWLEDGED);
        } else {
            return false;
        }
        return true;
    }

    void expired(StationTimer timer) {
        if (timer == StationTimer.KEY && state == KeyState.SOUNDING) {
            stopIfOver();
        } else if (timer == StationTimer.KEY) {
            happens(KeyEvent.PAUSE_OVER);
        } else {
            refusal = Cause.RECOVERY_ON_TIMER_EXPIRY;
            happens(timer == StationTimer.T336 ? KeyEvent.T336_EXPIRED : KeyEvent.T337_EXPIRED);
        }
    }

    private void stopIfOver() {
        if (state == KeyState.SOUNDING
                && !queue.element().held
                && !parts.timers().isRunning(StationTimer.KEY)) {
            happens(KeyEvent.LET_GO);
        }
    }

    private void happens(KeyEvent event) {
        var row = KeyTable.ROWS.row(state, event);
        if (row.isEmpty()) {
            parts.log().refused(state, event);
            return;
        }
        parts.log()
                .trace(
                        Level.DEBUG,
                        "key {0} {1} -> {2}",
                        state,
                        event,
                        row.get().next());
        state = row.get().next();
        row.get().actions().forEach(this::perform);
    }

    private void perform(KeyAction action) {
        switch (action) {
            case SEND_START ->
                send(new CallControl.StartDtmf(transaction, sounding().symbol()));
            case SEND_STOP -> send(new CallControl.StopDtmf(transaction));
            case START_T336 -> parts.timers().start(StationTimer.T336);
            case START_T337 -> parts.timers().start(StationTimer.T337);
            case START_TONE -> parts.timers().start(StationTimer.KEY, queue.element().nanos);
            case START_PAUSE -> parts.timers().start(StationTimer.KEY, TimeUnit.MILLISECONDS.toNanos(PAUSE_MILLIS));
            case STOP_TIMERS -> stopTimers();
            case TELL_SOUNDS -> tell(StationListener::keySounds);
            case TELL_LET_GO -> tell(StationListener::keyLetGo);
            case TELL_LEFT -> {
                tell(StationListener::keyLeft);
                queue.remove();
            }
            case TELL_REFUSED -> {
                Cause cause = refusal;
                parts.notifications().add(listener -> listener.keysRefused(cause));
            }
            case FORGET_ALL -> queue.clear();
            case SEND_NEXT -> sendNext();
        }
    }

    private DtmfKey sounding() {
        return queue.element().key;
    }

    private interface KeyNews {
        void tell(StationListener listener, DtmfKey key);
    }

    private void tell(KeyNews news) {
        DtmfKey key = sounding();
        parts.notifications().add(listener -> news.tell(listener, key));
    }

    private void send(CallControl message) {
        parts.radio().send(message);
    }

    private void stopTimers() {
        parts.timers().stop(StationTimer.T336);
        parts.timers().stop(StationTimer.T337);
        parts.timers().stop(StationTimer.KEY);
    }
}
