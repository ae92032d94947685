package simgsm.timer;

import java.util.Arrays;
import java.util.OptionalLong;

/** Running timers in a binary heap: start, cancel and expiry cost O(log n). */
final class TimerHeap {
    static final int GONE = -1;
    private static final int INITIAL_CAPACITY = 64;

    private Timer[] heap = new Timer[INITIAL_CAPACITY];
    private int size;
    private long started;
    private long nowNanos;
    private Runnable onEarlier = () -> {};

    long nowNanos() {
        return nowNanos;
    }

    int size() {
        return size;
    }

    OptionalLong nextDeadlineNanos() {
        return size == 0 ? OptionalLong.empty() : OptionalLong.of(heap[0].deadlineNanos);
    }

    void onEarlier(Runnable action) {
        onEarlier = action;
    }

    Timer start(long delayNanos, Runnable action) {
        Timer timer = new Timer(nowNanos + Math.max(0, delayNanos), started++, action);
        if (size == heap.length) {
            heap = Arrays.copyOf(heap, size * 2);
        }
        place(timer, size++);
        siftUp(timer);
        if (timer.position == 0) {
            onEarlier.run();
        }
        return timer;
    }

    void cancel(Timer timer) {
        if (timer == null || timer.position == GONE) {
            return;
        }
        int hole = timer.position;
        timer.position = GONE;
        Timer last = heap[--size];
        heap[size] = null;
        if (last != timer) {
            place(last, hole);
            siftDown(last);
            siftUp(last);
        }
    }

    void advance(long toNanos) {
        while (size > 0 && heap[0].deadlineNanos <= toNanos) {
            Timer due = heap[0];
            cancel(due);
            nowNanos = Math.max(nowNanos, due.deadlineNanos);
            due.action.run();
        }
        nowNanos = Math.max(nowNanos, toNanos);
    }

    private void siftUp(Timer timer) {
        while (timer.position > 0 && timer.isBefore(heap[(timer.position - 1) / 2])) {
            swapWithParent(timer);
        }
    }

    private void siftDown(Timer timer) {
        for (Timer child = smallerChild(timer); child != null && child.isBefore(timer); child = smallerChild(timer)) {
            swapWithParent(child);
        }
    }

    private Timer smallerChild(Timer timer) {
        int left = 2 * timer.position + 1;
        if (left >= size) {
            return null;
        }
        boolean rightIsSmaller = left + 1 < size && heap[left + 1].isBefore(heap[left]);
        return rightIsSmaller ? heap[left + 1] : heap[left];
    }

    private void swapWithParent(Timer timer) {
        int position = timer.position;
        Timer parent = heap[(position - 1) / 2];
        place(timer, parent.position);
        place(parent, position);
    }

    private void place(Timer timer, int position) {
        heap[position] = timer;
        timer.position = position;
    }
}
