package simgsm.center.smsc;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/** The attempts at one message. Most messages need one, and most of a long queue have had none. */
final class Attempts {
    /** A message that is tried for 63 weeks by the longest pause is tried 900 times. */
    static final int MAX_REMEMBERED = 20;

    private Deque<Attempt> latest;
    private int count;

    void add(Attempt attempt) {
        if (latest == null) {
            latest = new ArrayDeque<>(2);
        }
        if (latest.size() == MAX_REMEMBERED) {
            latest.removeFirst();
        }
        latest.addLast(attempt);
        count++;
    }

    /** Oldest first. */
    List<Attempt> latest() {
        return latest == null ? List.of() : List.copyOf(latest);
    }

    int count() {
        return count;
    }
}
