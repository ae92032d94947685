package simgsm.console;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * One event line: a name, then fields in order.
 *
 * @param fields unmodifiable, in the order in which they are printed
 */
public record Event(String name, Map<String, String> fields) {
    public Event {
        fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
    }

    /** An event without fields, to which {@link #with} adds. */
    public static Event of(String name) {
        return new Event(name, Map.of());
    }

    /** The same event with one field more; the value is printed by {@code toString}. */
    public Event with(String key, Object value) {
        Map<String, String> more = new LinkedHashMap<>(fields);
        more.put(key, String.valueOf(value));
        return new Event(name, more);
    }

    /** Whether it has the wanted event's name and all of its fields with the same text. */
    boolean answers(Event wanted) {
        return name.equals(wanted.name) && fields.entrySet().containsAll(wanted.fields.entrySet());
    }

    /** The line as printed, without its end. */
    @Override
    public String toString() {
        StringBuilder line = new StringBuilder(name);
        fields.forEach((key, value) -> line.append(' ').append(key).append('=').append(Quoted.write(value)));
        return line.toString();
    }
}
