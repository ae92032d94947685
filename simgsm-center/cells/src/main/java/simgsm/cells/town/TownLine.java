package simgsm.cells.town;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** One line of a town file: words in order, and settings {@code key=value} in any order after them. */
final class TownLine {
    private final String source;
    private final int number;
    private final Deque<String> words = new ArrayDeque<>();
    private final Map<String, String> settings = new LinkedHashMap<>();
    private final List<String> known = new ArrayList<>();

    TownLine(String source, int number, String text) throws TownFormatException {
        this.source = source;
        this.number = number;
        for (String word : text.strip().split("\\s+")) {
            int equals = word.indexOf('=');
            if (equals < 0) {
                if (!settings.isEmpty()) {
                    throw fault(quoted(word), "a setting KEY=VALUE, as all words after the first setting");
                }
                words.add(word);
            } else if (settings.put(word.substring(0, equals), word.substring(equals + 1)) != null) {
                throw fault("a second " + word.substring(0, equals) + "=", "each setting once");
            }
        }
    }

    TownFormatException fault(String found, String expected) {
        return new TownFormatException(source, number, found, expected);
    }

    static String quoted(String text) {
        return '"' + (text.length() > 40 ? text.substring(0, 40) + "..." : text) + '"';
    }

    boolean hasMore() {
        return !words.isEmpty();
    }

    /** @param what the expected element, for the error */
    String word(String what) throws TownFormatException {
        if (words.isEmpty()) {
            throw fault("the line's end", what);
        }
        return words.remove();
    }

    double number(String what) throws TownFormatException {
        return real(word(what), what);
    }

    private double real(String text, String what) throws TownFormatException {
        double value;
        try {
            value = Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw fault(quoted(text), what + ", a number");
        }
        if (!Double.isFinite(value)) {
            throw fault(quoted(text), what + ", a finite number");
        }
        return value;
    }

    private double inRange(String text, String what, double least, double most) throws TownFormatException {
        double value = real(text, what);
        if (value < least || value > most) {
            throw fault(quoted(text), what + ", " + plain(least) + " to " + plain(most));
        }
        return value;
    }

    /** A number without ".0". */
    private static String plain(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }

    double numberIn(String what, double least, double most) throws TownFormatException {
        return inRange(word(what), what, least, most);
    }

    TownPlace point(String what) throws TownFormatException {
        return new TownPlace(number("x of " + what + " in metres"), number("y of " + what + " in metres"));
    }

    /** An optional value. */
    double setting(String key, double otherwise, double least, double most) throws TownFormatException {
        known.add(key);
        String text = settings.remove(key);
        return text == null ? otherwise : inRange(text, key, least, most);
    }

    /** An optional whole number, in steps from its minimum. */
    int whole(String key, int otherwise, int least, int most, int step) throws TownFormatException {
        known.add(key);
        String text = settings.remove(key);
        if (text == null) {
            return otherwise;
        }
        double value = inRange(text, key, least, most);
        if (value != Math.rint(value) || (value - least) % step != 0) {
            throw fault(
                    quoted(text),
                    step == 1 ? key + ", a whole number" : key + ", " + least + " to " + most + " in steps of " + step);
        }
        return (int) value;
    }

    int whole(String key, int otherwise, int least, int most) throws TownFormatException {
        return whole(key, otherwise, least, most, 1);
    }

    /** A mandatory whole number. */
    int required(String key, int least, int most) throws TownFormatException {
        if (!settings.containsKey(key)) {
            throw fault("no " + key + "=", key + "=" + least + " to " + most);
        }
        return whole(key, least, least, most);
    }

    String text(String key, String otherwise) {
        known.add(key);
        String text = settings.remove(key);
        return text == null ? otherwise : text;
    }

    /** Refuses unread words. */
    void end() throws TownFormatException {
        if (!words.isEmpty()) {
            throw fault(quoted(words.peek()), known.isEmpty() ? "the line's end" : "settings of " + known);
        }
        if (!settings.isEmpty()) {
            String key = settings.keySet().iterator().next();
            throw fault(quoted(key + "="), known.isEmpty() ? "the line's end" : "one of " + known);
        }
    }
}
