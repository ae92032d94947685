package simgsm.center.msc;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import simgsm.air.Cause;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Calls for a mobile whose last call is still being cleared: it is not engaged any more, but would answer so. They are
 * held for as long as clearing takes, some milliseconds as a rule, so that whoever hangs up and dials again gets through.
 */
final class HeldCalls {
    /** A mobile that clears no faster counts as busy. */
    static final Duration PATIENCE = Duration.ofSeconds(5);

    private final Timers timers;
    private final Map<NetworkCall, Link> held = new LinkedHashMap<>();
    private final Map<NetworkCall, Timer> patience = new LinkedHashMap<>();

    HeldCalls(Timers timers) {
        this.timers = timers;
    }

    void hold(NetworkCall call, Link called) {
        held.put(call, called);
        patience.put(call, timers.start(PATIENCE.toNanos(), () -> giveUp(call)));
    }

    /** The call is over, or goes on. */
    void forget(NetworkCall call) {
        if (held.remove(call) != null) {
            timers.cancel(patience.remove(call));
        }
    }

    /** Hands out the calls whose mobile has become free or gone. */
    void release(Consumer<NetworkCall> goOn) {
        if (held.isEmpty()) {
            return;
        }
        List<NetworkCall> free = new ArrayList<>(held.keySet());
        free.removeIf(call -> held.get(call).isClearingCall() && !held.get(call).isClosed);
        free.forEach(this::forget);
        free.forEach(goOn);
    }

    private void giveUp(NetworkCall call) {
        forget(call);
        call.refuse(Cause.USER_BUSY);
    }
}
