package simgsm.event;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Name and fields of the events of one class, declared by an {@link EventLine}. */
public final class EventForm {
    private static final ClassValue<Optional<EventForm>> FORMS = new ClassValue<>() {
        @Override
        protected Optional<EventForm> computeValue(Class<?> type) {
            return Optional.ofNullable(type.getAnnotation(EventLine.class)).map(line -> of(type, line.value()));
        }
    };

    private final String name;
    private final List<EventField> fields;

    private EventForm(String name, List<EventField> fields) {
        this.name = name;
        this.fields = fields;
    }

    /** The form declared by the class of this event; empty for an event that is not printed. */
    public static Optional<EventForm> of(Object event) {
        return FORMS.get(event.getClass());
    }

    /** The form declared by this class; IllegalArgumentException if there is none. */
    public static EventForm of(Class<?> type) {
        return FORMS.get(type).orElseThrow(() -> new IllegalArgumentException(type.getName() + " declares no line"));
    }

    /**
     * Reads a form.
     *
     * @throws IllegalArgumentException if the class has no component or method of a path
     */
    public static EventForm of(Class<?> type, String line) {
        List<String> words = List.of(line.split(" "));
        return new EventForm(
                words.get(0),
                words.stream().skip(1).map(word -> EventField.of(type, word)).toList());
    }

    /** The event's name, the first word of the line. */
    public String name() {
        return name;
    }

    /**
     * The fields of an event in the order of the line. Values have their own types; an Optional is replaced by its content.
     *
     * @param given values by key that replace those of the event
     */
    public Map<String, Object> values(Object event, Map<String, ?> given) {
        Map<String, Object> values = new LinkedHashMap<>();
        for (EventField field : fields) {
            Object value = given.containsKey(field.key()) ? given.get(field.key()) : field.of(event);
            if (!field.isOptional() || !text(value).isEmpty()) {
                values.put(field.key(), value);
            }
        }
        return values;
    }

    /** A value as the console prints it: words in lower case, times of whole seconds, elements separated by commas. */
    public static String text(Object value) {
        if (value instanceof EventValue printed) {
            return text(printed.eventValue());
        } else if (value instanceof Enum<?> word) {
            return word.name().toLowerCase(Locale.ROOT);
        } else if (value instanceof Instant time) {
            return time.truncatedTo(ChronoUnit.SECONDS).toString();
        } else if (value instanceof Collection<?> elements) {
            return elements.stream().map(EventForm::text).collect(Collectors.joining(","));
        }
        return value == Optional.empty() ? "" : String.valueOf(value);
    }
}
