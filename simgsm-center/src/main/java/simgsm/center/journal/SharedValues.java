package simgsm.center.journal;

import java.util.HashMap;
import java.util.Map;

/** Keeps one object for equal values, while few different ones exist: numbers and origins occur in many messages. */
final class SharedValues {
    private static final int MOST = 100_000;

    private final Map<Object, Object> values = new HashMap<>();

    /** An equal earlier value, else this one. */
    @SuppressWarnings("unchecked") // equal records have one class
    <T> T of(T value) {
        Object before = values.size() < MOST ? values.putIfAbsent(value, value) : values.get(value);
        return before == null ? value : (T) before;
    }
}
