package simgsm.center;

import java.lang.System.Logger.Level;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.ExchangeListener;
import simgsm.console.Console;
import simgsm.console.Event;

/** Prints events on a thread of its own, so that a reader who is slow never holds up the exchange. */
final class EventPrinter implements ExchangeListener, AutoCloseable {
    private static final Event END = Event.of("end");
    /** How long the last lines may take at the program's end. */
    private static final long DRAIN_MILLIS = 2_000;

    /** Beyond this, a reader who has stopped reading loses events. The longest list is shorter. */
    private static final int MAX_UNPRINTED = 1_000_000;

    private static final System.Logger LOG = System.getLogger(EventPrinter.class.getName());

    private final Console console;
    private final BlockingQueue<Event> queue = new LinkedBlockingQueue<>(MAX_UNPRINTED);
    private final Thread thread = new Thread(this::run, "events");

    EventPrinter(Console console) {
        this.console = console;
        thread.setDaemon(true);
        thread.start();
    }

    void print(Event event) {
        if (!queue.offer(event)) {
            LOG.log(Level.DEBUG, "nobody reads our output; lost: {0}", event);
        }
    }

    @Override
    public void happened(ExchangeEvent event) {
        print(ConsoleEvents.of(event));
    }

    private void run() {
        try {
            for (Event event = queue.take(); event != END; event = queue.take()) {
                console.emit(event);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Prints what is left. */
    @Override
    public void close() {
        queue.offer(END);
        try {
            thread.join(DRAIN_MILLIS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
