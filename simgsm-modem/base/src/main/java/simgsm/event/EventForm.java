package simgsm.event;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.ParameterizedType;
import java.math.BigDecimal;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The name and the fields of the events of one class, as an {@link EventLine} declares them. */
public final class EventForm {
    private static final ClassValue<Optional<EventForm>> FORMS = new ClassValue<>() {
        @Override
        protected Optional<EventForm> computeValue(Class<?> type) {
            return Optional.ofNullable(type.getAnnotation(EventLine.class)).map(line -> of(type, line.value()));
        }
    };

    private final String name;
    private final List<Field> fields;

    private EventForm(String name, List<Field> fields) {
        this.name = name;
        this.fields = fields;
    }

    /** The form that the class of this event declares; empty for an event that is not printed. */
    public static Optional<EventForm> of(Object event) {
        return FORMS.get(event.getClass());
    }

    /** The form that this class declares; IllegalArgumentException if it declares none. */
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
                words.stream().skip(1).map(word -> Field.of(type, word)).toList());
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
        for (Field field : fields) {
            Object value = given.containsKey(field.key) ? given.get(field.key) : field.of(event);
            if (!field.isOptional || !text(value).isEmpty()) {
                values.put(field.key, value);
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

    /** @param path accessors, each of the result of the one before; empty for a value that the printer gives */
    private record Field(String key, List<Method> path, int decimals, boolean isOptional) {
        private static final Pattern FORM = Pattern.compile("\\[?([a-z0-9-]+)=([A-Za-z0-9.]*)(?::([0-9]))?]?");
        private static final int NOT_ROUNDED = -1;

        static Field of(Class<?> type, String word) {
            Matcher parts = FORM.matcher(word);
            if (!parts.matches()) {
                throw new IllegalArgumentException(type.getName() + ": expected KEY=PATH:DECIMALS, found " + word);
            }
            boolean isGiven = parts.group(2).isEmpty()
                    && Stream.of(type.getMethods())
                            .noneMatch(method -> method.getName().equals(parts.group(1)));
            String path = parts.group(2).isEmpty() ? parts.group(1) : parts.group(2);
            return new Field(
                    parts.group(1),
                    isGiven ? List.of() : path(type, path.split("\\.")),
                    parts.group(3) == null ? NOT_ROUNDED : Integer.parseInt(parts.group(3)),
                    word.startsWith("["));
        }

        private static List<Method> path(Class<?> type, String[] names) {
            List<Method> path = new ArrayList<>();
            Class<?> owner = type;
            for (String name : names) {
                try {
                    Method step = owner.getMethod(name);
                    step.setAccessible(true);
                    path.add(step);
                    owner = step.getGenericReturnType() instanceof ParameterizedType optional
                                    && step.getReturnType() == Optional.class
                            ? (Class<?>) optional.getActualTypeArguments()[0]
                            : step.getReturnType();
                } catch (NoSuchMethodException e) {
                    throw new IllegalArgumentException(owner.getName() + " has no public " + name, e);
                }
            }
            return path;
        }

        Object of(Object event) {
            if (path.isEmpty()) {
                throw new IllegalArgumentException(event + ": no value is given for " + key);
            }
            Object value = event;
            for (Method step : path) {
                value = content(invoke(step, value));
                if (value == Optional.empty()) {
                    return value;
                }
            }
            return decimals == NOT_ROUNDED ? value : rounded(((Number) value).doubleValue());
        }

        private static Object content(Object value) {
            if (value instanceof OptionalInt number) {
                return number.isPresent() ? number.getAsInt() : Optional.empty();
            }
            return value instanceof Optional<?> some && some.isPresent() ? some.get() : value;
        }

        private BigDecimal rounded(double number) {
            return BigDecimal.valueOf(Math.round(number * Math.pow(10, decimals)), decimals);
        }

        private static Object invoke(Method step, Object owner) {
            try {
                return step.invoke(owner);
            } catch (IllegalAccessException | InvocationTargetException e) {
                throw new IllegalStateException(step.toString(), e);
            }
        }
    }
}
