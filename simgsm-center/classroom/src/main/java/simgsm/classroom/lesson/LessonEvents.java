package simgsm.classroom.lesson;

import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.console.Event;
import simgsm.lesson.LessonRun;

/**
 * The events of all programs of a lesson: each goes to the run, and to a queue of its source, on which solutions wait as a
 * console does. Any thread may add; one thread waits.
 */
final class LessonEvents {
    private static final System.Logger LOG = System.getLogger(LessonEvents.class.getName());

    /** Events of a source that nothing has waited for yet; the oldest are dropped. */
    private static final int MOST_UNREAD = 10_000;

    private final LessonRun run;
    private final Map<String, ArrayDeque<Event>> unread = new HashMap<>();
    private final Set<String> ended = new HashSet<>();
    private Runnable changed = () -> {};
    private Consumer<String> chosen = name -> {};

    LessonEvents(LessonRun run) {
        this.run = run;
    }

    /** Called after each event, by the thread that has added it. */
    synchronized void onChange(Runnable listener) {
        changed = listener;
    }

    /** Called with the name of a lesson that is chosen in the help of a program's window. */
    synchronized void onLesson(Consumer<String> listener) {
        chosen = listener;
    }

    void add(String source, Event event) {
        LOG.log(System.Logger.Level.DEBUG, () -> source + ": " + event);
        Runnable listener;
        synchronized (this) {
            run.event(source, event);
            ArrayDeque<Event> queue = unread.computeIfAbsent(source, key -> new ArrayDeque<>());
            queue.addLast(event);
            if (queue.size() > MOST_UNREAD) {
                queue.removeFirst();
            }
            listener = event.name().equals("lesson")
                    ? () -> chosen.accept(event.fields().getOrDefault("name", ""))
                    : changed;
            notifyAll();
        }
        listener.run();
    }

    /** Changes or reads the run between two events. */
    synchronized void withRun(Consumer<LessonRun> action) {
        action.accept(run);
    }

    synchronized void begun(String source) {
        ended.remove(source);
    }

    synchronized void ended(String source) {
        ended.add(source);
        notifyAll();
    }

    /** Drops what a source has printed and nothing has waited for. */
    synchronized void skip(String source) {
        unread.remove(source);
    }

    /** Waits for the source's next event with this name and at least these fields; earlier ones are dropped. */
    synchronized void await(String source, Event wanted, double seconds) throws LessonFailure, InterruptedException {
        long deadline = System.nanoTime() + (long) (seconds * 1e9);
        ArrayDeque<Event> queue = unread.computeIfAbsent(source, key -> new ArrayDeque<>());
        while (true) {
            while (!queue.isEmpty()) {
                Event next = queue.removeFirst();
                if (next.name().equals(wanted.name())
                        && next.fields().entrySet().containsAll(wanted.fields().entrySet())) {
                    return;
                }
            }
            long left = deadline - System.nanoTime();
            if (left <= 0 || ended.contains(source)) {
                throw new LessonFailure(source + ": expected " + wanted
                        + (ended.contains(source) ? ", but the program has ended" : " within " + seconds + " s"));
            }
            TimeUnit.NANOSECONDS.timedWait(this, left);
        }
    }
}
