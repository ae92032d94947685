package simgsm.event;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.ParameterizedType;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * One field of an event's text.
 *
 * @param path accessors, each applied to the result of the one before; empty for a value given by the printer
 */
record EventField(String key, List<Method> path, int decimals, boolean isOptional) {
    private static final Pattern FORM = Pattern.compile("\\[?([a-z0-9-]+)=([A-Za-z0-9.]*)(?::([0-9]))?]?");
    private static final int NOT_ROUNDED = -1;

    static EventField of(Class<?> type, String word) {
        Matcher parts = FORM.matcher(word);
        if (!parts.matches()) {
            throw new IllegalArgumentException(type.getName() + ": expected KEY=PATH:DECIMALS, found " + word);
        }
        boolean isGiven = parts.group(2).isEmpty()
                && Stream.of(type.getMethods())
                        .noneMatch(method -> method.getName().equals(parts.group(1)));
        String path = parts.group(2).isEmpty() ? parts.group(1) : parts.group(2);
        return new EventField(
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
