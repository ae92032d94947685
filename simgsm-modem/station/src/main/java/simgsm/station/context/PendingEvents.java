package simgsm.station.context;

import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.Consumer;

/** Events of one station, delivered in order once its state is settled. */
public final class PendingEvents {
    private final Consumer<StationEvent> listener;
    private final StationLog log;
    private final Queue<StationEvent> queue = new ArrayDeque<>();
    private boolean delivering;

    PendingEvents(Consumer<StationEvent> listener, StationLog log) {
        this.listener = listener;
        this.log = log;
    }

    public void add(StationEvent event) {
        queue.add(event);
    }

    /** Delivers all events, including those added meanwhile; a call from within a delivery has no effect. */
    public void deliver() {
        if (delivering) {
            return;
        }
        delivering = true;
        for (StationEvent next = queue.poll(); next != null; next = queue.poll()) {
            try {
                listener.accept(next);
            } catch (RuntimeException e) {
                log.trace(Level.ERROR, "the receiver of an event failed: {0}", e);
            }
        }
        delivering = false;
    }
}
