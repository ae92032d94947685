package simrobot.source.child;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Ends the virtual machine of a file when a decision takes more than 1 s, when a thread that the file started still executes its code at two looks, one each 0.5 s,
 * and when the file ends the Java virtual machine. Time counts in periods of this thread, so that a busy machine, which delays
 * both, makes no decision late.
 */
final class Watchdog {
    private static final long PERIOD_MILLIS = 50;
    private static final int PERIODS_PER_SECOND = 20;
    private static final int MOST_THREADS = 50;

    private final Decider watched;
    private final Thread main;
    private final Thread thread = new Thread(this::run, "watchdog");
    private long seen;
    private int late;
    private Set<Thread> foreign = Set.of();

    Watchdog(Decider watched, Thread main) {
        this.watched = watched;
        this.main = main;
        thread.setDaemon(true);
        thread.setPriority(Thread.MAX_PRIORITY);
    }

    void start() {
        thread.start();
        Runtime.getRuntime().addShutdownHook(new Thread(this::explainExit, "exit"));
    }

    private void run() {
        try {
            for (int period = 1; ; period++) {
                Thread.sleep(PERIOD_MILLIS);
                look(period);
            }
        } catch (InterruptedException e) {
            watched.end(main.getStackTrace(), "thread", "it has interrupted the watchdog");
        }
    }

    private void look(int period) {
        try {
            lookAtDecision();
            boolean isCrowd = Thread.activeCount() > MOST_THREADS;
            if (isCrowd || period % (PERIODS_PER_SECOND / 2) == 0) {
                lookAtThreads(isCrowd);
            }
        } catch (OutOfMemoryError e) {
            // the decision that fills the memory meets this error itself, or is too late at one of the next looks
        }
    }

    private void lookAtDecision() {
        long now = watched.decision();
        late = now % 2 == 1 && now == seen ? late + 1 : 0;
        seen = now;
        if (late >= PERIODS_PER_SECOND) {
            StackTraceElement[] trace = main.getStackTrace();
            // a read of a socket or a terminal is a native method, and its thread counts as runnable
            boolean isNative = trace.length > 0
                    && trace[0].isNativeMethod()
                    && trace[0].getClassName().matches("(java\\.io|sun\\.nio)\\..*");
            boolean waits = isNative || main.getState() != Thread.State.RUNNABLE;
            String text = waits ? "it waits for something" : "it computes without end";
            watched.end(trace, waits ? "waits" : "loops", "no decision within 1 s: " + text);
        }
    }

    /** @param isCrowd whether there are too many to wait for the second look */
    private void lookAtThreads(boolean isCrowd) {
        Set<Thread> now = new HashSet<>();
        for (Map.Entry<Thread, StackTraceElement[]> each :
                Thread.getAllStackTraces().entrySet()) {
            Thread found = each.getKey();
            if (found != main && watched.line(each.getValue()) > 0) {
                now.add(found);
                if (isCrowd || foreign.contains(found)) {
                    watched.end(each.getValue(), "thread", "a thread of its own still runs after the decision");
                }
            }
        }
        foreign = now;
    }

    /** Runs while the virtual machine exits; a signal needs no words. */
    private void explainExit() {
        Thread.getAllStackTraces().values().stream()
                .filter(trace -> Arrays.stream(trace)
                        .anyMatch(frame -> frame.getClassName().equals("java.lang.Runtime")))
                .findFirst()
                .ifPresent(trace -> watched.end(trace, "exit", "System.exit is called"));
    }
}
