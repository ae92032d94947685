package simgsm.phone.screen;

import java.util.List;

/**
 * A text for the display, put into words when it is drawn.
 *
 * @param key of the phone's bundle; empty for a literal text
 * @param arguments of the bundle's text, or the literal text; {@code Words}, causes, notes and times among them are
 *     put into words first
 */
public record Words(String key, List<Object> arguments) {
    /** No text. */
    public static final Words NONE = plain("");

    public static Words of(String key, Object... arguments) {
        return new Words(key, List.of(arguments));
    }

    /** A text that is the same in every language, such as a number. */
    public static Words plain(String text) {
        return new Words("", List.of(text));
    }
}
