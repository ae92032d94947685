package simgsm.tools.load;

import java.util.BitSet;
import java.util.concurrent.TimeUnit;
import java.util.function.IntConsumer;

/**
 * A row of like tasks of which so many are under way at a time. The stations' thread begins and ends them; another waits
 * for all to have ended.
 */
final class Window {
    private final int count;
    private final int width;
    private final IntConsumer begin;
    private final BitSet open = new BitSet();
    private int next;
    private long startNanos = System.nanoTime();
    private long endNanos = startNanos;
    private int done;
    private int failed;

    /**
     * @param count tasks in all, numbered from 0
     * @param width under way at most
     * @param begin begins the task of that number
     */
    Window(int count, int width, IntConsumer begin) {
        this.count = count;
        this.width = width;
        this.begin = begin;
    }

    /** Begins the first ones. */
    void start() {
        synchronized (this) {
            startNanos = System.nanoTime();
            endNanos = startNanos;
        }
        fill();
    }

    private void fill() {
        for (int task = take(); task >= 0; task = take()) {
            begin.accept(task);
        }
    }

    private synchronized int take() {
        if (next == count || open.cardinality() >= width) {
            return -1;
        }
        open.set(next);
        return next++;
    }

    /** A task is over; one that was over already, or never began, is left alone. */
    void ended(int task, boolean isWell) {
        synchronized (this) {
            if (!open.get(task)) {
                return;
            }
            open.clear(task);
            done += isWell ? 1 : 0;
            failed += isWell ? 0 : 1;
            endNanos = System.nanoTime();
            if (done + failed == count) {
                notifyAll();
            }
        }
        fill();
    }

    /** Waits until all tasks have ended, or none has for so long. */
    synchronized void await(long patienceNanos) throws InterruptedException {
        long since = System.nanoTime();
        while (done + failed < count) {
            long left = Math.max(since, endNanos) + patienceNanos - System.nanoTime();
            if (left <= 0) {
                return;
            }
            TimeUnit.NANOSECONDS.timedWait(this, left);
        }
    }

    /** Tasks that have ended well. */
    synchronized int done() {
        return done;
    }

    int count() {
        return count;
    }

    /** Tasks that have ended well a second, from the first one's beginning to the last one's end. */
    synchronized double perSecond() {
        return endNanos == startNanos ? 0 : done * 1e9 / (endNanos - startNanos);
    }
}
