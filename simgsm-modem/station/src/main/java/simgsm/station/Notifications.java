package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.Consumer;
import java.util.function.Predicate;

/** What the listener is still to be told: told only once the station's state is settled, in order. */
final class Notifications {
    private final StationListener listener;
    private final StationLog log;
    private final Queue<Consumer<StationListener>> queue = new ArrayDeque<>();
    private boolean delivering;

    Notifications(StationListener listener, StationLog log) {
        this.listener = listener;
        this.log = log;
    }

    void add(Consumer<StationListener> notification) {
        queue.add(notification);
    }

    /** Asks the listener something that it can say at once. */
    boolean ask(Predicate<StationListener> question) {
        return question.test(listener);
    }

    /** Tells everything, also what is added meanwhile; an act from within a notification does not nest another delivery. */
    void deliver() {
        if (delivering) {
            return;
        }
        delivering = true;
        try {
            for (var next = queue.poll(); next != null; next = queue.poll()) {
                deliver(next);
            }
        } finally {
            delivering = false;
        }
    }

    private void deliver(Consumer<StationListener> notification) {
        try {
            notification.accept(listener);
        } catch (RuntimeException e) {
            log.trace(Level.ERROR, "the station''s user failed: {0}", e);
        }
    }
}
