package simgsm.center.smpp;

import static simgsm.center.smpp.CircuitBreaker.BreakerState.ABANDONED;
import static simgsm.center.smpp.CircuitBreaker.BreakerState.CLOSED;
import static simgsm.center.smpp.CircuitBreaker.BreakerState.HALF_OPEN;
import static simgsm.center.smpp.CircuitBreaker.BreakerState.OPEN;

import java.lang.System.Logger.Level;
import java.time.Duration;
import simgsm.center.smsc.RetrySchedule;
import simgsm.state.StateMachine;
import simgsm.state.StateTable;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Decides by a session's answers if it gets deliver_sm. After {@link #MAX_FAILURES} successive failures it gets none
 * for a pause, then one as a trial. A refused trial prolongs the pause; an unanswered one ends the session.
 */
public final class CircuitBreaker {
    /** Maximum of successive temporary refusals and missing answers. */
    static final int MAX_FAILURES = 10;

    /** The pause after missing answers; after refusals it is 1, 2, 4 ... 60 s. */
    private static final Duration SILENCE_PAUSE = Duration.ofMinutes(1);

    private static final System.Logger LOG = System.getLogger(CircuitBreaker.class.getName());

    /** The usual names: current flows while the breaker is closed. */
    public enum BreakerState {
        CLOSED,
        OPEN,
        /** The next deliver_sm is a trial. */
        HALF_OPEN,
        ABANDONED
    }

    public enum BreakerEvent {
        /** An answer other than a temporary refusal. */
        SUCCESS,
        /** {@link #MAX_FAILURES} successive failures, or a failed trial. */
        FAILURE,
        PAUSE_OVER,
        /** A trial without an answer, after {@link #MAX_FAILURES} deliver_sm without one. */
        SILENCE
    }

    public enum BreakerAction {
        BEGIN_PAUSE,
        END_PAUSE,
        RESUME_DELIVERY,
        END_SESSION
    }

    public static final StateTable<BreakerState, BreakerEvent, BreakerAction> TABLE = new StateTable<
                    BreakerState, BreakerEvent, BreakerAction>("SMPP delivery", CLOSED)
            .on(CLOSED, BreakerEvent.FAILURE, OPEN, BreakerAction.BEGIN_PAUSE)
            .on(OPEN, BreakerEvent.PAUSE_OVER, HALF_OPEN, BreakerAction.RESUME_DELIVERY)
            .on(OPEN, BreakerEvent.SUCCESS, CLOSED, BreakerAction.END_PAUSE, BreakerAction.RESUME_DELIVERY)
            .on(HALF_OPEN, BreakerEvent.SUCCESS, CLOSED, BreakerAction.RESUME_DELIVERY)
            .on(HALF_OPEN, BreakerEvent.FAILURE, OPEN, BreakerAction.BEGIN_PAUSE)
            .on(HALF_OPEN, BreakerEvent.SILENCE, ABANDONED, BreakerAction.END_SESSION);

    private final Object session;
    private final Timers timers;
    private final Runnable resumed;
    private final Runnable abandoned;
    private final StateMachine<BreakerState, BreakerEvent, BreakerAction> machine;
    private final LogThrottle silenceLog = new LogThrottle();
    private int failures;
    private int unanswered;
    private int pauses;
    private boolean isTried;
    private Timer pause;

    /**
     * @param session named in the log
     * @param resumed called when the session may get deliver_sm again
     * @param abandoned called to end the session
     */
    CircuitBreaker(Object session, Timers timers, Runnable resumed, Runnable abandoned) {
        this.session = session;
        this.timers = timers;
        this.resumed = resumed;
        this.abandoned = abandoned;
        machine = new StateMachine<>(TABLE, session, this::perform);
    }

    /** True if a deliver_sm may be sent now. */
    boolean permits() {
        return machine.state() == CLOSED || machine.state() == HALF_OPEN && !isTried;
    }

    /** Rank among several sessions, the lowest first: 0 a trial, 1 a session that answers, 2 one that does not. */
    int rank() {
        return machine.state() == HALF_OPEN ? 0 : unanswered == 0 ? 1 : 2;
    }

    boolean hasEndedSession() {
        return machine.state() == ABANDONED;
    }

    void sent() {
        isTried = true;
    }

    /** The session has accepted a deliver_sm, or refused it permanently. */
    void succeeded() {
        failures = 0;
        unanswered = 0;
        pauses = 0;
        if (machine.state() != CLOSED) {
            machine.fire(BreakerEvent.SUCCESS);
        }
    }

    /** The session has refused a deliver_sm temporarily. */
    void refused() {
        unanswered = 0;
        failed(1);
    }

    /** The response timer of this number of deliver_sm has expired. */
    void unanswered(int count) {
        unanswered += count;
        int logged = silenceLog.count(count, timers.nowNanos());
        if (logged > 0) {
            LOG.log(
                    Level.INFO,
                    "{0}: {1} deliver_sm unanswered for {2} s",
                    session,
                    logged,
                    DeliveryWindow.RESPONSE.toSeconds());
        }
        if (machine.state() == HALF_OPEN && unanswered > MAX_FAILURES) {
            machine.fire(BreakerEvent.SILENCE);
        } else {
            failed(count);
        }
    }

    private void failed(int count) {
        failures += count;
        if (machine.state() == HALF_OPEN || machine.state() == CLOSED && failures >= MAX_FAILURES) {
            machine.fire(BreakerEvent.FAILURE);
        }
    }

    private void perform(BreakerAction action) {
        switch (action) {
            case BEGIN_PAUSE -> beginPause();
            case END_PAUSE -> timers.cancel(pause);
            case RESUME_DELIVERY -> {
                isTried = false;
                resumed.run();
            }
            case END_SESSION -> {
                LOG.log(
                        Level.WARNING,
                        "{0}: unbound, {1} deliver_sm in a row without an answer, a trial among them",
                        session,
                        unanswered);
                abandoned.run();
            }
        }
    }

    private void beginPause() {
        boolean isSilent = unanswered >= MAX_FAILURES;
        Duration length = isSilent ? SILENCE_PAUSE : RetrySchedule.pauseWhenBusy(++pauses);
        LOG.log(
                pauses > 1 ? Level.INFO : Level.WARNING,
                "{0}: gets no deliver_sm for {1} s; of the last ones {2} in a row {3}",
                session,
                length.toSeconds(),
                failures,
                isSilent ? "were not answered" : "were refused for now or not answered");
        pause = timers.start(length.toNanos(), () -> machine.fire(BreakerEvent.PAUSE_OVER));
    }

    /** The session has ended. */
    void end() {
        timers.cancel(pause);
    }
}
