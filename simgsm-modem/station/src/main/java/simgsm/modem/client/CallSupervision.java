package simgsm.modem.client;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.modem.ModemEvent;
import simgsm.station.context.StationEvent;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * The supervision of an attached modem's active call. The modem is asked for its calls every 0.25 s, which shows that
 * modem and call are alive: after 0.5 s without an answer the modem is lost, so that a robot at full speed stops within
 * 2.5 s of the modem's last sign. A key reported while an answer is due waits for it, so that no order is completed by a
 * modem that has just lost a key.
 */
final class CallSupervision {
    private static final long POLL_NANOS = TimeUnit.MILLISECONDS.toNanos(250);
    private static final int POLL_LIMIT_MILLIS = 500;
    /** States of {@code +CLCC} (TS 27.007, 7.18). */
    private static final int CALL_ACTIVE = 0;

    private static final int CALL_WAITING = 5;
    private static final int STATE = 2;

    private final AttachedCall call;
    private final CommandDialogue dialogue;
    private final Timers timers;
    private final Consumer<StationEvent> listener;
    /** Events received while a list of calls was due. */
    private final Deque<ModemEvent> held = new ArrayDeque<>();

    private boolean isActive;
    private boolean isPollUnderWay;
    private boolean isDisturbed;
    private Timer timer;

    CallSupervision(AttachedCall call, CommandDialogue dialogue, Timers timers, Consumer<StationEvent> listener) {
        this.call = call;
        this.dialogue = dialogue;
        this.timers = timers;
        this.listener = listener;
    }

    void begin() {
        isActive = true;
        isPollUnderWay = false;
        timer = timers.start(POLL_NANOS, this::poll);
    }

    void end() {
        isActive = false;
        held.clear();
        timers.cancel(timer);
    }

    /** A line may have been the report of a key, or a line of the list. */
    void disturbed() {
        isDisturbed = true;
    }

    /** Reports a key, after the list of calls that is due. */
    void report(ModemEvent event) {
        if (isPollUnderWay) {
            held.add(event);
        } else {
            listener.accept(event);
        }
    }

    private void poll() {
        timer = timers.start(POLL_NANOS, this::poll);
        if (dialogue.isIdle()) {
            isPollUnderWay = true;
            isDisturbed = false;
            dialogue.sendFirst(AttachedCall.list().within(POLL_LIMIT_MILLIS), this::listed);
        }
    }

    private void listed(ModemAnswer answer) {
        isPollUnderWay = false;
        if (!isActive || answer.ending() == ModemAnswer.Ending.TIMED_OUT) {
            return;
        }
        List<Integer> states = answer.lines().stream()
                .map(line -> AnswerFields.of(line).number(STATE))
                .toList();
        if (answer.isOk() && !states.contains(CALL_ACTIVE) && !isDisturbed) {
            call.cleared();
            return;
        }
        for (ModemEvent event = held.poll(); event != null; event = held.poll()) {
            listener.accept(event);
        }
        if (states.contains(CALL_WAITING)) {
            call.secondCallWaits();
        }
    }
}
