package simgsm.center.journal;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/** What was written, acknowledged, given up and shown, and whether that can be. */
final class Account {
    /** Messages that differ only in the time at which they were written. */
    record Key(String from, String to, String text) {}

    private static final class Counts {
        int written;
        int acknowledged;
        int shown;
        /** Ids of those that ended in another way than by being delivered. */
        final Set<Long> givenUp = new HashSet<>(1);
    }

    private final Map<Key, Counts> counts = new HashMap<>();
    private int acknowledged;
    private int shown;

    private Counts of(Key key) {
        return counts.computeIfAbsent(key, any -> new Counts());
    }

    void written(Key key) {
        of(key).written++;
    }

    void acknowledged(Key key) {
        Invariant.tell(() -> "acknowledged: " + key);
        acknowledged++;
        of(key).acknowledged++;
    }

    void givenUp(Key key, long id) {
        of(key).givenUp.add(id);
    }

    void shown(Key key) {
        Invariant.tell(() -> "shown: " + key);
        shown++;
        Counts here = of(key);
        here.shown++;
        Invariant.holds(here.shown <= here.written, () -> key + " is shown " + here.shown + " times");
    }

    int acknowledgedCount() {
        return acknowledged;
    }

    int shownCount() {
        return shown;
    }

    /** Everything has come to rest. */
    void close() {
        counts.forEach((key, here) -> Invariant.holds(
                here.acknowledged <= here.shown + here.givenUp.size(),
                () -> key + " was acknowledged " + here.acknowledged + " times, shown " + here.shown
                        + " times and given up " + here.givenUp.size() + " times"));
    }
}
