package simgsm.web;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import simgsm.console.JsonString;
import simgsm.event.EventForm;

/** Writes JSON (RFC 8259) field by field. */
public final class JsonText {
    private final StringBuilder text = new StringBuilder();
    private boolean first = true;

    public JsonText() {}

    /** Begins an array or object. */
    public JsonText open(char bracket) {
        separate();
        text.append(bracket);
        first = true;
        return this;
    }

    /** Ends an array or object. */
    public JsonText close(char bracket) {
        text.append(bracket);
        first = false;
        return this;
    }

    /** The name of the next value. */
    public JsonText name(String name) {
        value(name);
        text.append(':');
        first = true;
        return this;
    }

    /** @param value may be null */
    public JsonText value(String value) {
        separate();
        text.append(value == null ? null : JsonString.quoted(value));
        return this;
    }

    public JsonText value(boolean value) {
        separate();
        text.append(value);
        return this;
    }

    public JsonText value(long value) {
        separate();
        text.append(value);
        return this;
    }

    /** A number with the given number of decimals, without exponent and without minus zero. */
    public JsonText value(double value, int decimals) {
        separate();
        String number = String.format(Locale.ROOT, "%." + decimals + "f", value);
        text.append(number.matches("-0\\.?0*") ? number.substring(1) : number);
        return this;
    }

    /** Any value of {@link JsonReader} or number; numbers that are not finite become null, since JSON has none. */
    public JsonText any(Object value) {
        if (value instanceof Map<?, ?> object) {
            open('{');
            object.forEach((name, each) -> name(name.toString()).any(each));
            return close('}');
        }
        if (value instanceof List<?> array) {
            open('[');
            array.forEach(this::any);
            return close(']');
        }
        if (value instanceof String string) {
            return value(string);
        }
        separate();
        boolean isBinary = value instanceof Double || value instanceof Float;
        text.append(isBinary && !Double.isFinite(((Number) value).doubleValue()) ? null : value);
        return this;
    }

    /** An object with the fields declared by the event's class. */
    public JsonText object(Object event) {
        return object(EventForm.of(event).orElseThrow().values(event, Map.of()));
    }

    /** An object with these fields. */
    public JsonText object(Map<String, Object> values) {
        return open('{').fields(values).close('}');
    }

    /** Fields of the open object: numbers and truth values as such, times with milliseconds, others as texts. */
    public JsonText fields(Map<String, Object> values) {
        values.forEach((name, value) -> {
            name(name).separate();
            text.append(
                    value instanceof Number || value instanceof Boolean
                            ? value.toString()
                            : JsonString.quoted(
                                    value instanceof Instant time
                                            ? time.truncatedTo(ChronoUnit.MILLIS)
                                                    .toString()
                                            : EventForm.text(value)));
        });
        return this;
    }

    private void separate() {
        if (!first) {
            text.append(',');
        }
        first = false;
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
