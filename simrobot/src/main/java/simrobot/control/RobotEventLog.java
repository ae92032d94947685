package simrobot.control;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simgsm.console.Event;
import simgsm.event.EventForm;

/** The last 2000 events of all robots. Filled on the simulation's thread, read by any. */
public final class RobotEventLog {
    /** Some hours with a few robots, some seconds with a hundred. */
    public static final int CAPACITY = 2000;

    private static final Set<String> KEPT = names();

    private final LongSupplier timeNanos;
    private final Deque<LoggedEvent> events = new ArrayDeque<>();
    private List<LoggedEvent> published = List.of();
    private boolean changed;

    private static Set<String> names() {
        Set<String> names = Stream.of(RobotEvent.class.getPermittedSubclasses())
                .map(type -> EventForm.of(type).name())
                .collect(Collectors.toSet());
        names.removeAll(Set.of("keys", "tone", "pose", "error"));
        names.add("type-unknown");
        return names;
    }

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

    /** True if the log keeps this event: one of a robot, but no key, tone or pose. */
    public static boolean keeps(Event line) {
        return line.fields().containsKey("robot") && KEPT.contains(line.name());
    }

    /** Adds an event if the log keeps it. */
    public void add(String robot, RobotEvent event) {
        LoggedEvent logged = new LoggedEvent(timeNanos.getAsLong(), robot, event);
        if (!keeps(logged.line())) {
            return;
        }
        synchronized (this) {
            if (events.size() == CAPACITY) {
                events.removeFirst();
            }
            events.addLast(logged);
            changed = true;
        }
    }
}
