package simgsm.center.journal;

import java.util.HashMap;
import java.util.Map;

/** One object for equal values, as long as there are few different ones: numbers and origins stand in many messages. */
final class SharedValues {
    private static final int MOST = 100_000;

    private final Map<Object, Object> values = new HashMap<>();

    /** An equal value that was given before, else this one. */
    @SuppressWarnings("unchecked") // Equal objects of records are of one class.
    <T> T of(T value) {
        Object before = values.size() < MOST ? values.putIfAbsent(value, value) : values.get(value);
        return before == null ? value : (T) before;
    }
}
