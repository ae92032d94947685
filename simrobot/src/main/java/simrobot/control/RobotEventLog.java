package simrobot.control;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.LongSupplier;

/** The last 2000 events of all robots. Filled on the simulation's thread, read by any. */
public final class RobotEventLog {
    /** Some hours with a few robots, some seconds with a crowd. */
    public static final int CAPACITY = 2000;

    private final LongSupplier timeNanos;
    private final Deque<LoggedEvent> events = new ArrayDeque<>();
    private List<LoggedEvent> published = List.of();
    private boolean changed;

    /** @param timeNanos supplies the simulated time; called on the simulation's thread */
    public RobotEventLog(LongSupplier timeNanos) {
        this.timeNanos = timeNanos;
    }

    /** Returns the events, oldest first; the same object until an event is added. */
    public synchronized List<LoggedEvent> newest() {
        if (changed) {
            published = List.copyOf(events);
            changed = false;
        }
        return published;
    }

    /** Adds an event, unless it is a key, a tone or a pose. */
    public void add(String robot, RobotEvent event) {
        if (event instanceof RobotEvent.KeyReceived
                || event instanceof RobotEvent.ToneSent
                || event instanceof RobotEvent.PoseReported) {
            return;
        }
        LoggedEvent logged = new LoggedEvent(timeNanos.getAsLong(), robot, event);
        synchronized (this) {
            if (events.size() == CAPACITY) {
                events.removeFirst();
            }
            events.addLast(logged);
            changed = true;
        }
    }
}
