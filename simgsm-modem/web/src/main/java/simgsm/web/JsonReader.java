package simgsm.web;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads JSON (RFC 8259): an object as a {@link Map} in its order, an array as a {@link List}, a number as a {@link
 * BigDecimal}, the others as {@link String}, {@link Boolean} and null. Of two equal names in an object the last counts.
 */
public final class JsonReader {
    private static final int MOST_DEPTH = 32;
    private static final Pattern NUMBER = Pattern.compile("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][+-]?[0-9]{1,5})?");

    private final String text;
    private int at;
    private int depth;

    private JsonReader(String text) {
        this.text = text;
    }

    /** @throws IllegalArgumentException naming the position, from 1, and the expected syntax */
    public static Object parse(String text) {
        JsonReader reader = new JsonReader(text);
        Object value = reader.value();
        reader.skipSpace();
        if (reader.at < text.length()) {
            throw reader.expected("the end");
        }
        return value;
    }

    /** @throws IllegalArgumentException if the text is not one JSON object */
    @SuppressWarnings("unchecked") // Objects are read as such maps only.
    public static Map<String, Object> object(String text) {
        if (parse(text) instanceof Map<?, ?> object) {
            return (Map<String, Object>) object;
        }
        throw new IllegalArgumentException("expected a JSON object");
    }

    private Object value() {
        skipSpace();
        return switch (peek()) {
            case '{' -> object();
            case '[' -> array();
            case '"' -> string();
            case 't' -> word("true", Boolean.TRUE);
            case 'f' -> word("false", Boolean.FALSE);
            case 'n' -> word("null", null);
            default -> number();
        };
    }

    private Map<String, Object> object() {
        Map<String, Object> fields = new LinkedHashMap<>();
        enter();
        for (boolean isFirst = true; !isNext('}'); isFirst = false) {
            separate(isFirst);
            String name = string();
            skipSpace();
            take(':');
            fields.put(name, value());
        }
        depth--;
        return fields;
    }

    private List<Object> array() {
        List<Object> items = new ArrayList<>();
        enter();
        for (boolean isFirst = true; !isNext(']'); isFirst = false) {
            separate(isFirst);
            items.add(value());
        }
        depth--;
        return items;
    }

    private void enter() {
        if (++depth > MOST_DEPTH) {
            throw expected("at most " + MOST_DEPTH + " levels");
        }
        at++;
    }

    private boolean isNext(char end) {
        skipSpace();
        boolean isEnd = peek() == end;
        at += isEnd ? 1 : 0;
        return isEnd;
    }

    private void separate(boolean isFirst) {
        if (!isFirst) {
            take(',');
            skipSpace();
        }
    }

    private String string() {
        take('"');
        StringBuilder value = new StringBuilder();
        for (char next = next(); next != '"'; next = next()) {
            if (next < ' ') {
                at--;
                throw expected("no control character in a string");
            }
            value.append(next == '\\' ? escaped() : next);
        }
        return value.toString();
    }

    private char escaped() {
        char kind = next();
        int plain = "\"\\/bfnrt".indexOf(kind);
        if (plain >= 0) {
            return "\"\\/\b\f\n\r\t".charAt(plain);
        }
        String digits = text.substring(at, Math.min(text.length(), at + 4));
        if (kind != 'u' || !digits.matches("[0-9a-fA-F]{4}")) {
            throw expected("an escape of RFC 8259");
        }
        at += digits.length();
        return (char) Integer.parseInt(digits, 16);
    }

    private Object word(String word, Object value) {
        if (!text.startsWith(word, at)) {
            throw expected("a value");
        }
        at += word.length();
        return value;
    }

    private BigDecimal number() {
        Matcher number = NUMBER.matcher(text).region(at, text.length());
        if (!number.lookingAt()) {
            throw expected("a value");
        }
        at = number.end();
        return new BigDecimal(number.group());
    }

    private void take(char wanted) {
        if (peek() != wanted) {
            throw expected("'" + wanted + "'");
        }
        at++;
    }

    private char next() {
        if (at == text.length()) {
            throw expected("the end of the string");
        }
        return text.charAt(at++);
    }

    /** The next character; 0 at the end. */
    private char peek() {
        return at < text.length() ? text.charAt(at) : 0;
    }

    private void skipSpace() {
        while (at < text.length() && " \t\n\r".indexOf(text.charAt(at)) >= 0) {
            at++;
        }
    }

    private IllegalArgumentException expected(String what) {
        return new IllegalArgumentException("JSON, position " + (at + 1) + ": expected " + what);
    }
}
