package simgsm.tools.load;

import java.util.BitSet;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;

/**
 * Tasks of one kind, a limited number at a time. The stations' thread begins and ends them; another thread waits
 * until all have ended.
 */
final class TaskWindow {
    private final int count;
    private final int width;
    private final IntConsumer begin;
    private final BitSet open = new BitSet();
    private int next;
    private boolean isFilling;
    private long startNanos = System.nanoTime();
    private long endNanos = startNanos;
    private int done;
    private int failed;

    /**
     * @param count tasks in all, numbered from 0
     * @param width tasks open at a time
     * @param begin begins the task with this number; the task may end before the call returns
     */
    TaskWindow(int count, int width, IntConsumer begin) {
        this.count = count;
        this.width = width;
        this.begin = begin;
    }

    /** Begins the first tasks. */
    void start() {
        synchronized (this) {
            startNanos = System.nanoTime();
            endNanos = startNanos;
        }
        fill();
    }

    /** Begins tasks while there is room. Tasks ended within it make room that the outermost call fills. */
    private void fill() {
        if (isFilling) {
            return;
        }
        isFilling = true;
        try {
            for (int task = take(); task >= 0; task = take()) {
                begin.accept(task);
            }
        } finally {
            isFilling = false;
        }
    }

    private synchronized int take() {
        if (next == count || open.cardinality() >= width) {
            return -1;
        }
        open.set(next);
        return next++;
    }

    /** Ends a task; a task that is not open is ignored. */
    void ended(int task, boolean succeeded) {
        synchronized (this) {
            if (!open.get(task)) {
                return;
            }
            open.clear(task);
            done += succeeded ? 1 : 0;
            failed += succeeded ? 0 : 1;
            endNanos = System.nanoTime();
            if (done + failed == count) {
                notifyAll();
            }
        }
        fill();
    }

    /** Waits until all tasks have ended, or none has ended within the time-out. */
    synchronized void await(long timeoutNanos) throws InterruptedException {
        long since = System.nanoTime();
        while (done + failed < count) {
            long left = Math.max(since, endNanos) + timeoutNanos - System.nanoTime();
            if (left <= 0) {
                return;
            }
            TimeUnit.NANOSECONDS.timedWait(this, left);
        }
    }

    /** Tasks that have succeeded. */
    synchronized int done() {
        return done;
    }

    /** Tasks in all. */
    int count() {
        return count;
    }

    /** Tasks that have succeeded per second, from the beginning of the first to the end of the last. */
    synchronized double perSecond() {
        return endNanos == startNanos ? 0 : done * 1e9 / (endNanos - startNanos);
    }
}
