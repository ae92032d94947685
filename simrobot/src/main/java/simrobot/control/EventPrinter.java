package simrobot.control;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.function.Consumer;
import simgsm.console.Console;
import simgsm.console.Event;

/**
 * Prints events on a thread of its own, in order, so that a reader who is slow to take them holds up no robot until many
 * thousand are waiting.
 */
public final class EventPrinter implements Consumer<Event>, AutoCloseable {
    private static final int MAX_WAITING = 100_000;
    private static final Event END = Event.of("end of events");

    private final BlockingQueue<Event> waiting = new ArrayBlockingQueue<>(MAX_WAITING);
    private final Thread thread;

    public EventPrinter(Console console) {
        thread = new Thread(() -> print(console), "event printer");
        thread.setDaemon(true);
        thread.start();
    }

    @Override
    public void accept(Event event) {
        try {
            waiting.put(event);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void print(Console console) {
        try {
            for (Event event = waiting.take(); event != END; event = waiting.take()) {
                console.emit(event);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Returns when everything accepted before has been printed. */
    @Override
    public void close() {
        accept(END);
        try {
            thread.join();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
