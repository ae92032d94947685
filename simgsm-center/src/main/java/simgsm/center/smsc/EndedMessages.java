package simgsm.center.smsc;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;

/** The histories of those that have ended lately. */
final class EndedMessages {
    static final int MAX_REMEMBERED = 1_000;

    private final Deque<MessageHistory> latest = new ArrayDeque<>();

    void add(MessageHistory history) {
        if (latest.size() == MAX_REMEMBERED) {
            latest.removeFirst();
        }
        latest.addLast(history);
    }

    /** The newest first, no more than so many. */
    List<MessageHistory> newest(int most) {
        List<MessageHistory> found = new ArrayList<>(Math.min(most, latest.size()));
        Iterator<MessageHistory> each = latest.descendingIterator();
        while (each.hasNext() && found.size() < most) {
            found.add(each.next());
        }
        return found;
    }

    Optional<MessageHistory> find(long id) {
        return latest.stream().filter(history -> history.message().id() == id).findFirst();
    }
}
