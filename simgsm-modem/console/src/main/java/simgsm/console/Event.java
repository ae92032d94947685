package simgsm.console;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import simgsm.event.EventForm;

/**
 * One event line: a name, then fields in order.
 *
 * @param fields unmodifiable, in the order in which they are printed
 */
public record Event(String name, Map<String, String> fields) {
    private static final int OCTETS_OF_EVENT = 200;
    private static final int OCTETS_OF_FIELD = 100;

    /** Divisor of the heap for the octets of waiting events. */
    private static final int PART_OF_HEAP = 8;

    /** Most octets of events waiting for one reader. */
    static final long MAX_OCTETS_HELD = Runtime.getRuntime().maxMemory() / PART_OF_HEAP;

    public Event {
        fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
    }

    /** An event without fields. */
    public static Event of(String name) {
        return new Event(name, Map.of());
    }

    /**
     * The event of a record that declares its line.
     *
     * @param given values by key that replace the record's
     * @throws IllegalArgumentException if its class declares no line
     */
    public static Event from(Object record, Map<String, ?> given) {
        EventForm form = EventForm.of(record).orElseThrow(() -> new IllegalArgumentException("no line: " + record));
        Map<String, String> fields = new LinkedHashMap<>();
        form.values(record, given).forEach((key, value) -> fields.put(key, EventForm.text(value)));
        return new Event(form.name(), fields);
    }

    /** The event of a record with all values of its line. */
    public static Event from(Object record) {
        return from(record, Map.of());
    }

    /** A copy with a further field; the value is converted by {@code toString}. */
    public Event with(String key, Object value) {
        Map<String, String> more = new LinkedHashMap<>(fields);
        more.put(key, String.valueOf(value));
        return new Event(name, more);
    }

    /**
     * Reads a line as a program prints it; words without {@code =} are left out.
     *
     * @throws CommandException for a broken quote
     */
    public static Event parse(String line) throws CommandException {
        ConsoleCommand words = ConsoleCommand.parse(line);
        Map<String, String> fields = new LinkedHashMap<>();
        for (String word : words.words()) {
            int equals = word.indexOf('=');
            if (equals > 0) {
                fields.put(word.substring(0, equals), word.substring(equals + 1));
            }
        }
        return new Event(words.name(), fields);
    }

    /** True if name and all fields of {@code wanted} are equal to those here. */
    boolean matches(Event wanted) {
        return name.equals(wanted.name) && fields.entrySet().containsAll(wanted.fields.entrySet());
    }

    /** Estimated octets of memory. */
    int octetsHeld() {
        int octets = OCTETS_OF_EVENT;
        for (String value : fields.values()) {
            octets += OCTETS_OF_FIELD + Character.BYTES * value.length();
        }
        return octets;
    }

    /** The line as printed, without its end. */
    @Override
    public String toString() {
        StringBuilder line = new StringBuilder(name);
        fields.forEach((key, value) -> line.append(' ').append(key).append('=').append(ConsoleQuoting.write(value)));
        return line.toString();
    }
}
